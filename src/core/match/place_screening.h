#ifndef PLACE_MEMORY_CORE_MATCH_PLACE_SCREENING_H
#define PLACE_MEMORY_CORE_MATCH_PLACE_SCREENING_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/index/place_index.h"
#include "core/match/fixed_metric.h"
#include "core/match/seed_grid.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// Where a place lies in an index: kBlockSize times its block, and its slot there.
using PlaceSlot = std::uint32_t;

/// What screening a place showed.
struct ScreenedPlace {
  std::int64_t score;  ///< the best of all seeds, in the fixed point of the metric
  PlaceSlot place;
  std::uint32_t seed;  ///< of the grid it was screened with
};

/// Screens the places of one index: scores their coarse cells at the seeds of a grid.
class PlaceScreening {
 public:
  /// Keeps references to all of these. `poll` may throw.
  PlaceScreening(const PlaceIndex& places, const FixedMetric& metric,
                 const std::function<void()>& poll, support::WorkerPool& pool)
      : places_(places), metric_(metric), poll_(poll), pool_(pool) {}

  const PlaceBlock& blockOf(PlaceSlot place) const;
  PlaceId idOf(PlaceSlot place) const;
  CellPlanes cellsOf(PlaceSlot place) const;

  /// All places, each at its best seed.
  std::vector<ScreenedPlace> screenAll(const SeedGrid& grid) const;
  /// All places, without scores.
  std::vector<ScreenedPlace> everyPlace() const;

  /// Scores up to kBlockPlaces places.
  void score(const SeedGrid& grid, const ScreenedPlace* begin, const ScreenedPlace* end,
             SeedScores& scores) const;

 private:
  const PlaceIndex& places_;
  const FixedMetric& metric_;
  const std::function<void()>& poll_;
  support::WorkerPool& pool_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_PLACE_SCREENING_H
