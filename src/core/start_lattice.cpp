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
      side_(1 + 2 * static_cast<std::size_t>(most_cells_ / look.cells)),
      factors_(metric.factors(look.shares)),
      kernel_(fastestBlockKernel()) {
  const int most_turns = circular_ ? window.turns : window.turns - window.turns % look.turns;
  const int last_turn = circular_ ? window.turns - 1 : most_turns;
  first_turn_ = -most_turns;
  turns_ = 1 + static_cast<std::size_t>((last_turn - first_turn_) / look.turns);
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

std::vector<Alignment> StartLattice::bestStarts(const std::vector<BlockScores>& scores,
                                                std::size_t place, std::size_t most) const {
  const std::size_t shifts = side_ * side_;
  std::vector<std::size_t> best;
  for (std::size_t first = 0; first < size(); first += shifts) {
    std::size_t of_turn = first;
    for (std::size_t i = first + 1; i < first + shifts; ++i) {
      if (scores[i][place] > scores[of_turn][place]) of_turn = i;
    }
    best.push_back(of_turn);
  }
  std::stable_sort(best.begin(), best.end(), [&](std::size_t a, std::size_t b) {
    return scores[a][place] > scores[b][place];
  });
  if (best.size() > most) best.resize(most);
  std::vector<Alignment> starts;
  starts.reserve(best.size());
  for (const std::size_t i : best) starts.push_back(start(i));
  return starts;
}

}  // namespace place_memory::core
