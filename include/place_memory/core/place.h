#ifndef PLACE_MEMORY_CORE_PLACE_H
#define PLACE_MEMORY_CORE_PLACE_H

#include <chrono>
#include <cstdint>
#include <string>

#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// A node of the topological/metric map (paper 3). Its evidence grid stays in the store.
struct Place {
  PlaceId id = kNoPlace;
  std::string label;  ///< not empty, unique in the map, UTF-8
  /// Pose of the place's grid in the map frame: x and y are the place's Cartesian location, yaw is
  /// the direction of compass east as it was there.
  Pose2d map_from_place;
  std::chrono::nanoseconds learned{0};  ///< when its scan ended
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_H
