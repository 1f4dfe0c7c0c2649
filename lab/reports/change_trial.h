#ifndef PLACE_MEMORY_REPORTS_CHANGE_TRIAL_H
#define PLACE_MEMORY_REPORTS_CHANGE_TRIAL_H

#include <cstddef>
#include <cstdint>

#include "config/parameters.h"
#include "core/grid/grid_changes.h"
#include "sim/world/world.h"

namespace place_memory::reports {

/// What reports of changes said, and what was so.
struct ChangeScore {
  std::size_t places = 0;  ///< that were known again
  std::size_t doors = 0;   ///< seen from a place
  std::size_t doors_right = 0;
  std::size_t doors_flipped = 0;  ///< of them that were opened or closed
  std::size_t doors_flipped_right = 0;
  std::size_t moved = 0;  ///< things, seen from a place
  std::size_t moved_seen = 0;
  std::size_t changes = 0;  ///< reported
  std::size_t false_changes = 0;

  void add(const ChangeScore& other);
};

/// Learns every place of the world, opens or closes three doors of ten, moves every other chair and
/// every tenth piece of furniture, and comes back to each place, half a metre off at the most.
ChangeScore tryChanges(const sim::World& world, std::uint64_t seed,
                       const config::Parameters& parameters,
                       const core::GridChangeOptions& options);

}  // namespace place_memory::reports

#endif  // PLACE_MEMORY_REPORTS_CHANGE_TRIAL_H
