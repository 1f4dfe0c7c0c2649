#ifndef PLACE_MEMORY_CORE_EXPLORE_FRONTIERS_H
#define PLACE_MEMORY_CORE_EXPLORE_FRONTIERS_H

#include <cstdint>
#include <vector>

#include "core/explore/free_space.h"
#include "core/explore/grid_ways.h"

namespace place_memory::core {

/// Where free space opens into what is not known yet (Yamauchi 1997).
struct Frontier {
  FreeSpace::Cell cell = 0;  ///< where the robot is to go: of its cells the middle one
  double width = 0.0;        ///< from end to end [m]
  double opens = 0.0;        ///< what is not known about its middle, nor was in sight [m^2]
};

struct FrontierOptions {
  double least_width = 0.5;  ///< narrower ones lead nowhere for a robot [m]
  double least_opens = 0.8;  ///< what shows less is a nook [m^2]
  double widest = 3.0;       ///< wider ones are cut in pieces [m]
  double looks_out = 2.0;    ///< around a frontier it is counted what is unknown [m]
};

/// All of them: cells with room for the robot that have unknown ones beside them, in pieces that
/// hang together, without those in `looked_at`. They need not be reached from anywhere. `in_sight`:
/// by cell, whether it was in sight of the way; what is unknown there opens nothing.
std::vector<Frontier> frontiersOf(const FreeSpace& space, const FrontierOptions& options,
                                  const std::vector<MapDisc>& looked_at,
                                  const std::vector<std::uint8_t>& in_sight);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_FRONTIERS_H
