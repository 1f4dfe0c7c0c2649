#ifndef PLACE_MEMORY_CORE_EXPLORE_SIGHT_H
#define PLACE_MEMORY_CORE_EXPLORE_SIGHT_H

#include <cstdint>
#include <vector>

#include "core/explore/free_space.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

struct SightOptions {
  double reach = 4.0;  ///< of the sonars, in which they do not miss what there is [m]
  /// So far beyond what is known to be empty the robot has looked too, though the sonars told
  /// nothing of it [m].
  double beyond = 1.2;
};

/// By cell, whether it lay in sight of the robot's way, with nothing between that stands: what is
/// unknown there stays so, however often the robot comes back.
std::vector<std::uint8_t> inSight(const FreeSpace& space, const std::vector<Pose2d>& trail,
                                  const SightOptions& options);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_SIGHT_H
