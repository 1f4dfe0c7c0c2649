#include "start_lattice.h"

#include <algorithm>

#include "coarse_planes.h"
#include "pair_kernel.h"

namespace place_memory::core {
namespace {

BitPlane shifted(const BitPlane& plane, CellShift shift) {
  BitPlane moved{};
  const int first = std::max(0, shift.rows);
  const int end = std::min(kGridSize, kGridSize + shift.rows);
  const std::uint64_t* from = plane.data() + (first - shift.rows);
  std::uint64_t* to = moved.data() + first;
  for (int row = 0; row < end - first; ++row) {
    to[row] = shift.columns >= 0 ? from[row] << shift.columns : from[row] >> -shift.columns;
  }
  return moved;
}

CellTotals count(const CellPlanes& cells) {
  const std::uint64_t* o = cells.occupied.data();
  const std::uint64_t* e = cells.empty.data();
  const PlaneCounts n = countPlanes({o, e, o, e, kGridSize, 0});
  return {static_cast<std::uint16_t>(n.occupied), static_cast<std::uint16_t>(n.empty)};
}

}  // namespace

// Measured: what pairs of coarse cells told of the pairs of cells where simulated places aligned.
const Look kCloseLook{2, 3, kCoarseRows, coarsen, {3.2, 3.2, 3.2, 3.2}};
const Look kFirstLook{3, 4, kCoarsestRows, coarsenMost, {4.7, 7.7, 8.2, 20.8}};

StartLattice::StartLattice(const QueryPlanes& query, const FixedMetric& metric,
                           const SearchWindow& window, const Look& look, WorkerPool& pool)
    : look_(look),
      circular_(window.circular),
      most_cells_(window.cells - window.cells % look.cells),
      side_(static_cast<std::size_t>(2 * (most_cells_ / look.cells) + 1)),
      factors_(metric.factors(look.shares)),
      kernel_(fastestBlockKernel()) {
  const int most_turns = circular_ ? window.turns : window.turns - window.turns % look.turns;
  const int last_turn = circular_ ? window.turns - 1 : most_turns;
  first_turn_ = -most_turns;
  turns_ = static_cast<std::size_t>((last_turn - first_turn_) / look.turns + 1);
  query_.resize(turns_ * side_ * side_ * look.rows);
  offsets_.resize(turns_ * side_ * side_);
  pool.run(turns_, [&](std::size_t turn) {
    for (std::size_t i = turn * side_ * side_; i < (turn + 1) * side_ * side_; ++i) {
      const Alignment at = start(i);
      const CellPlanes& turned = query.at(at.turn);
      CellPlanes cells;
      cells.occupied = shifted(turned.occupied, at.shift);
      cells.empty = shifted(turned.empty, at.shift);
      look.coarsen(cells, query_.data() + i * look.rows);
      offsets_[i] = metric.ofTransform(count(cells), at.shift, at.turn);
    }
  });
}

Alignment StartLattice::start(std::size_t index) const {
  const auto coordinate = [this](std::size_t i) {
    return static_cast<int>(i) * look_.cells - most_cells_;
  };
  Alignment alignment;
  alignment.shift.columns = coordinate(index % side_);
  alignment.shift.rows = coordinate(index / side_ % side_);
  alignment.turn = first_turn_ + static_cast<int>(index / (side_ * side_)) * look_.turns;
  return alignment;
}

BlockBest StartLattice::score(const BlockRow* places, std::vector<BlockScores>& scores) const {
  scores.resize(size());
  return kernel_({places, query_.data(), look_.rows, size(), factors_, offsets_.data()},
                 scores.data());
}

std::vector<std::size_t> StartLattice::peaks(const std::vector<BlockScores>& scores,
                                             std::size_t place, std::size_t most) const {
  std::vector<std::size_t> best;
  const auto higher = [&](std::size_t a, std::size_t b) {
    return scores[a][place] > scores[b][place];
  };
  for (std::size_t i = 0; i < size(); ++i) {
    const bool counts = best.size() < most || higher(i, best.back());
    if (!counts || !isPeak(scores, place, i)) continue;
    if (best.size() == most) best.pop_back();
    best.insert(std::upper_bound(best.begin(), best.end(), i, higher), i);
  }
  return best;
}

/// Of starts that score the same, the first is higher.
bool StartLattice::isPeak(const std::vector<BlockScores>& scores, std::size_t place,
                          std::size_t index) const {
  const auto side = static_cast<int>(side_);
  const auto turns = static_cast<int>(turns_);
  const auto at = static_cast<int>(index);
  const int turn = at / (side * side), row = at / side % side, column = at % side;
  const std::int64_t score = scores[index][place];
  for (int t = turn - 1; t <= turn + 1; ++t) {
    if (!circular_ && (t < 0 || t >= turns)) continue;
    const int on = (t + turns) % turns;
    for (int r = std::max(0, row - 1); r <= std::min(side - 1, row + 1); ++r) {
      for (int c = std::max(0, column - 1); c <= std::min(side - 1, column + 1); ++c) {
        const int other = (on * side + r) * side + c;
        const std::int64_t others = scores[static_cast<std::size_t>(other)][place];
        if (others > score || (others == score && other < at)) return false;
      }
    }
  }
  return true;
}

}  // namespace place_memory::core
