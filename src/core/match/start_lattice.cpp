#include "core/match/start_lattice.h"

#include <algorithm>

#include "core/kernels/coarse_planes.h"

namespace place_memory::core {
namespace {

/// Measured: what pairs of coarse cells told of the pairs of cells where simulated places aligned.
constexpr PairShares kShares{4.7, 7.7, 8.2, 20.8};

/// So few are not worth waking other threads for.
constexpr std::size_t kTurnsATask = 8;

}  // namespace

StartLattice::StartLattice(const QueryPlanes& query, const FixedMetric& metric,
                           const SearchWindow& window, const Look& look, support::WorkerPool& pool)
    : look_(look),
      circular_(window.circular),
      most_cells_(window.cells - window.cells % look_.cells),
      side_(1 + 2 * static_cast<std::size_t>(most_cells_ / look_.cells)),
      factors_(metric.factors(kShares)),
      kernel_(fastestBlockKernel()) {
  const int most_turns = circular_ ? window.turns : window.turns - window.turns % look_.turns;
  const int last_turn = circular_ ? window.turns - 1 : most_turns;
  first_turn_ = -most_turns;
  turns_ = 1 + static_cast<std::size_t>((last_turn - first_turn_) / look_.turns);
  query_.resize(turns_ * side_ * side_ * kCoarsestRows);
  offsets_.resize(turns_ * side_ * side_);
  pool.run((turns_ + kTurnsATask - 1) / kTurnsATask, [&](std::size_t task) {
    const std::size_t end = std::min(turns_, (task + 1) * kTurnsATask);
    for (std::size_t turn = task * kTurnsATask; turn < end; ++turn) prepare(query, metric, turn);
  });
}

void StartLattice::prepare(const QueryPlanes& query, const FixedMetric& metric, std::size_t turn) {
  const std::size_t shifts = side_ * side_;
  const std::size_t first = turn * shifts;
  const CellPlanes& turned = query.at(start(first).turn);
  std::vector<int> by;
  for (std::size_t i = 0; i < side_; ++i) by.push_back(start(i).shift.columns);
  std::vector<CellTotals> inside(shifts);
  coarsenShifted(turned, by, query_.data() + first * kCoarsestRows, inside.data());
  const int at_turn = start(first).turn;
  for (std::size_t i = 0, row = 0; row < side_; ++row) {
    for (std::size_t column = 0; column < side_; ++column, ++i) {
      offsets_[first + i] = metric.ofTransform(inside[i], {by[column], by[row]}, at_turn);
    }
  }
}

void StartLattice::look(const CoarsestBlock& places, LookScores& scores) const {
  const std::size_t shifts = side_ * side_;
  scores.scratch.resize(shifts);
  scores.of_turn.resize(turns_);
  for (std::size_t turn = 0; turn < turns_; ++turn) {
    const std::size_t first = turn * shifts;
    scores.of_turn[turn] = kernel_({places.data(), query_.data() + first * kCoarsestRows,
                                    kCoarsestRows, shifts, factors_, offsets_.data() + first},
                                   scores.scratch.data());
  }
}

ScoredStart StartLattice::best(const LookScores& scores, std::size_t place) const {
  std::size_t best = 0;
  for (std::size_t turn = 1; turn < turns_; ++turn) {
    if (scores.of_turn[turn].score[place] > scores.of_turn[best].score[place]) best = turn;
  }
  return startOf(scores, best, place);
}

void StartLattice::bestStarts(const LookScores& scores, std::size_t place, std::size_t most,
                              std::vector<ScoredStart>& starts) const {
  starts.clear();
  starts.reserve(turns_);
  for (std::size_t turn = 0; turn < turns_; ++turn) {
    starts.emplace_back() = startOf(scores, turn, place);
  }
  if (starts.size() <= most) return;
  std::nth_element(starts.begin(), starts.begin() + static_cast<std::ptrdiff_t>(most), starts.end(),
                   [](const ScoredStart& a, const ScoredStart& b) {
                     return a.score != b.score ? a.score > b.score : a.start < b.start;
                   });
  starts.resize(most);
  std::sort(starts.begin(), starts.end(),
            [](const ScoredStart& a, const ScoredStart& b) { return a.start < b.start; });
}

ScoredStart StartLattice::startOf(const LookScores& scores, std::size_t turn,
                                  std::size_t place) const {
  const BlockBest& best = scores.of_turn[turn];
  const auto shift = static_cast<std::size_t>(best.transform[place]);
  return {best.score[place], static_cast<std::uint32_t>(turn * side_ * side_ + shift)};
}

}  // namespace place_memory::core
