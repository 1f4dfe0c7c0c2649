#ifndef PLACE_MEMORY_CORE_PLACE_H
#define PLACE_MEMORY_CORE_PLACE_H

#include <array>
#include <chrono>
#include <cstdint>
#include <string>

#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// 128 random bits that no other place of any robot has, so that stores can be merged.
using PlaceIdentity = std::array<std::uint8_t, 16>;

/// A node of the topological/metric map (paper 3). Its evidence grid stays in the store.
struct Place {
  PlaceId id = kNoPlace;
  PlaceIdentity identity{};  ///< all 0: none, as in maps that never were in a store
  std::string label;         ///< not empty, unique in the map, UTF-8
  /// Pose of the place's grid in the map frame (of its session): x and y are the place's Cartesian
  /// location, yaw is the direction of compass east as it was there.
  Pose2d map_from_place;
  std::chrono::nanoseconds learned{0};  ///< when its scan ended
  SessionId session = kFirstSession;    ///< in whose frame map_from_place lies
  Pose2d place_from_robot;              ///< where the robot stood when the place's scan ended

  bool operator==(const Place& other) const {
    return id == other.id && identity == other.identity && label == other.label &&
           map_from_place == other.map_from_place && learned == other.learned &&
           session == other.session && place_from_robot == other.place_from_robot;
  }
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_H
