#include "core/match/seed_grid.h"

#include <algorithm>

#include "core/kernels/coarse_planes.h"

namespace place_memory::core {
namespace {

/// Measured: what pairs of coarse cells told of the pairs of cells where simulated places aligned.
constexpr PairShares kShares{4.7, 7.7, 8.2, 20.8};

/// So few are not worth waking other threads for.
constexpr std::size_t kRotationsATask = 8;

}  // namespace

SeedGrid::SeedGrid(const QueryPlanes& query, const FixedMetric& metric, const SearchWindow& window,
                   const SeedSpacing& spacing, support::WorkerPool& pool)
    : spacing_(spacing),
      circular_(window.circular),
      most_cells_(window.cells - window.cells % spacing_.cells),
      side_(1 + 2 * static_cast<std::size_t>(most_cells_ / spacing_.cells)),
      factors_(metric.factors(kShares)),
      kernel_(chosenKernel(blockKernels())) {
  const int most_rotations =
      circular_ ? window.rotations : window.rotations - window.rotations % spacing_.rotations;
  const int last_rotation = circular_ ? window.rotations - 1 : most_rotations;
  first_rotation_ = -most_rotations;
  rotations_ = 1 + static_cast<std::size_t>((last_rotation - first_rotation_) / spacing_.rotations);
  query_.resize(rotations_ * side_ * side_ * kCoarsestRows);
  offsets_.resize(rotations_ * side_ * side_);
  pool.run((rotations_ + kRotationsATask - 1) / kRotationsATask, [&](std::size_t task) {
    const std::size_t end = std::min(rotations_, (task + 1) * kRotationsATask);
    for (std::size_t rotation = task * kRotationsATask; rotation < end; ++rotation)
      prepare(query, metric, rotation);
  });
}

void SeedGrid::prepare(const QueryPlanes& query, const FixedMetric& metric, std::size_t rotation) {
  const std::size_t shifts = side_ * side_;
  const std::size_t first = rotation * shifts;
  const CellPlanes& rotated = query.at(seed(first).rotation);
  std::vector<int> by;
  for (std::size_t i = 0; i < side_; ++i) by.push_back(seed(i).shift.columns);
  std::vector<CellTotals> inside(shifts);
  coarsenShifted(rotated, by, query_.data() + first * kCoarsestRows, inside.data());
  const int at_rotation = seed(first).rotation;
  for (std::size_t i = 0, row = 0; row < side_; ++row) {
    for (std::size_t column = 0; column < side_; ++column, ++i) {
      offsets_[first + i] = metric.ofTransform(inside[i], {by[column], by[row]}, at_rotation);
    }
  }
}

void SeedGrid::score(const CoarsestBlock& places, SeedScores& scores) const {
  const std::size_t shifts = side_ * side_;
  scores.scratch.resize(shifts);
  scores.of_rotation.resize(rotations_);
  for (std::size_t rotation = 0; rotation < rotations_; ++rotation) {
    const std::size_t first = rotation * shifts;
    scores.of_rotation[rotation] =
        kernel_({places.data(), query_.data() + first * kCoarsestRows, kCoarsestRows, shifts,
                 factors_, offsets_.data() + first},
                scores.scratch.data());
  }
}

ScoredSeed SeedGrid::best(const SeedScores& scores, std::size_t place) const {
  std::size_t best = 0;
  for (std::size_t rotation = 1; rotation < rotations_; ++rotation) {
    if (scores.of_rotation[rotation].score[place] > scores.of_rotation[best].score[place])
      best = rotation;
  }
  return seedOf(scores, best, place);
}

void SeedGrid::bestSeeds(const SeedScores& scores, std::size_t place, std::size_t most,
                         std::vector<ScoredSeed>& seeds) const {
  seeds.clear();
  seeds.reserve(rotations_);
  for (std::size_t rotation = 0; rotation < rotations_; ++rotation) {
    seeds.emplace_back() = seedOf(scores, rotation, place);
  }
  if (seeds.size() <= most) return;
  std::nth_element(seeds.begin(), seeds.begin() + static_cast<std::ptrdiff_t>(most), seeds.end(),
                   [](const ScoredSeed& a, const ScoredSeed& b) {
                     return a.score != b.score ? a.score > b.score : a.seed < b.seed;
                   });
  seeds.resize(most);
  std::sort(seeds.begin(), seeds.end(),
            [](const ScoredSeed& a, const ScoredSeed& b) { return a.seed < b.seed; });
}

ScoredSeed SeedGrid::seedOf(const SeedScores& scores, std::size_t rotation,
                            std::size_t place) const {
  const BlockBest& best = scores.of_rotation[rotation];
  const auto shift = static_cast<std::size_t>(best.transform[place]);
  return {best.score[place], static_cast<std::uint32_t>(rotation * side_ * side_ + shift)};
}

}  // namespace place_memory::core
