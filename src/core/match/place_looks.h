#ifndef PLACE_MEMORY_CORE_MATCH_PLACE_LOOKS_H
#define PLACE_MEMORY_CORE_MATCH_PLACE_LOOKS_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/index/place_index.h"
#include "core/match/fixed_metric.h"
#include "core/match/start_lattice.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// Where a place lies in an index: kBlockSize times its block, and its slot there.
using PlaceSlot = std::uint32_t;

/// What a look at a place showed.
struct Glimpse {
  std::int64_t score;  ///< the best of all starts, in the fixed point of the metric
  PlaceSlot place;
  std::uint32_t start;  ///< of the lattice that was looked through
};

/// Looks at places of one index.
class PlaceLooks {
 public:
  /// Keeps references to all of these. `poll` may throw.
  PlaceLooks(const PlaceIndex& places, const FixedMetric& metric, const std::function<void()>& poll,
             support::WorkerPool& pool)
      : places_(places), metric_(metric), poll_(poll), pool_(pool) {}

  const PlaceBlock& blockOf(PlaceSlot place) const;
  PlaceId idOf(PlaceSlot place) const;
  CellPlanes cellsOf(PlaceSlot place) const;

  /// All places, as the lattice shows them.
  std::vector<Glimpse> lookAtAll(const StartLattice& lattice) const;
  /// All places, none looked at.
  std::vector<Glimpse> everyPlace() const;

  /// Looks at the places of up to kBlockPlaces glimpses.
  void look(const StartLattice& lattice, const Glimpse* begin, const Glimpse* end,
            LookScores& scores) const;

 private:
  const PlaceIndex& places_;
  const FixedMetric& metric_;
  const std::function<void()>& poll_;
  support::WorkerPool& pool_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_PLACE_LOOKS_H
