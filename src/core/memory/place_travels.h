#ifndef PLACE_MEMORY_CORE_MEMORY_PLACE_TRAVELS_H
#define PLACE_MEMORY_CORE_MEMORY_PLACE_TRAVELS_H

#include <chrono>
#include <vector>

#include "core/map/kept_map.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// On a drive the robot came from one place to another one, and to no other between.
struct PlaceTravel {
  PlaceId from = kNoPlace;
  PlaceId to = kNoPlace;
  /// Where it stood in the frames in which it stood at the places when they were made.
  Pose2d from_from_departure;
  Pose2d to_from_arrival;
  Pose2d motion;  ///< from departure to arrival, as odometry measured it
  std::chrono::nanoseconds departed{0};
  std::chrono::nanoseconds arrived{0};
};

/// All that the scans of a drive show, in their order. A scan was taken at the place that it is, or
/// at the nearest of those that it was matched to.
std::vector<PlaceTravel> travelsOf(const KeptMap& drive);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_PLACE_TRAVELS_H
