#include "start_lattice.h"

#include <algorithm>
#include <cstdlib>

#include "coarse_planes.h"
#include "pair_kernel.h"

namespace place_memory::core {
namespace {

/// Cells that lie on the learned grid after the shift.
CellTotals countInside(const CellPlanes& cells, CellShift shift) {
  const int rows = kGridSize - std::abs(shift.rows);
  const std::uint64_t* o = cells.occupied.data() + std::max(0, -shift.rows);
  const std::uint64_t* e = cells.empty.data() + std::max(0, -shift.rows);
  const PlaneCounts n = countPlanes({o, e, o, e, rows, shift.columns});
  return {static_cast<std::uint16_t>(n.occupied), static_cast<std::uint16_t>(n.empty)};
}

}  // namespace

// Measured: what pairs of coarse cells told of the pairs of cells where simulated places aligned.
const Look kCloseLook{2, 3, kCoarseRows, coarsenShifted, {3.2, 3.2, 3.2, 3.2}};
const Look kFirstLook{3, 4, kCoarsestRows, coarsenMostShifted, {4.7, 7.7, 8.2, 20.8}};

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
  const std::size_t shifts = side_ * side_;
  pool.run(turns_, [&](std::size_t turn) {
    const std::size_t first = turn * shifts;
    const CellPlanes& turned = query.at(start(first).turn);
    std::vector<CellShift> all;
    for (std::size_t i = first; i < first + shifts; ++i) {
      const Alignment at = start(i);
      all.push_back(at.shift);
      offsets_[i] = metric.ofTransform(countInside(turned, at.shift), at.shift, at.turn);
    }
    look.coarsen(turned, all, query_.data() + first * look.rows);
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
  // Copied for their order in memory.
  std::vector<std::int64_t> of_place(size());
  for (std::size_t i = 0; i < size(); ++i) of_place[i] = scores[i][place];
  std::vector<std::size_t> best;
  const auto higher = [&](std::size_t a, std::size_t b) { return of_place[a] > of_place[b]; };
  for (std::size_t i = 0; i < size(); ++i) {
    const bool counts = best.size() < most || higher(i, best.back());
    if (!counts || !isPeak(of_place, i)) continue;
    if (best.size() == most) best.pop_back();
    best.insert(std::upper_bound(best.begin(), best.end(), i, higher), i);
  }
  return best;
}

/// Of starts that score the same, the first is higher.
bool StartLattice::isPeak(const std::vector<std::int64_t>& scores, std::size_t index) const {
  const std::size_t row = index / side_ % side_, column = index % side_;
  const std::size_t turn = index / (side_ * side_);
  const auto rises = [&](std::size_t other) {
    return scores[other] > scores[index] || (scores[other] == scores[index] && other < index);
  };
  // Those beside it first: they mostly tell.
  if (column > 0 && rises(index - 1)) return false;
  if (column + 1 < side_ && rises(index + 1)) return false;
  const bool wraps = circular_ && turns_ > 1;
  for (std::size_t t = turn + turns_ - 1; t <= turn + turns_ + 1; ++t) {
    if (!wraps && (t < turns_ || t >= 2 * turns_)) continue;
    for (std::size_t r = row - std::min<std::size_t>(row, 1); r <= std::min(side_ - 1, row + 1);
         ++r) {
      for (std::size_t c = column - std::min<std::size_t>(column, 1);
           c <= std::min(side_ - 1, column + 1); ++c) {
        if (rises((t % turns_ * side_ + r) * side_ + c)) return false;
      }
    }
  }
  return true;
}

}  // namespace place_memory::core
