#ifndef PLACE_MEMORY_NODE_GO_ROBOT_FINDER_H
#define PLACE_MEMORY_NODE_GO_ROBOT_FINDER_H

#include <tf2/buffer_core.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "node/drive/map_driver.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// Where the robot is, by the newest odometry.
struct RobotFix {
  std::chrono::nanoseconds stamp{0};
  core::Pose2d odom_from_base;
  core::Pose2d map_from_base;
  bool is_assumed = false;  ///< nothing tells where odometry's frame lies in the map
};

/// Tells who drives the robot where it is on the map: by the drive along with it (mode map or
/// localize), or by odometry and the scan that was learned or recognized last. Thread-safe.
class RobotFinder {
 public:
  /// All must outlive it.
  RobotFinder(const config::Parameters& parameters, const tf2::BufferCore& buffer,
              const core::PlaceMemory& memory, const MapDriver& driver)
      : parameters_(parameters), buffer_(buffer), memory_(memory), driver_(driver) {}

  struct Found {
    std::optional<RobotFix> fix;
    std::string problem;           ///< why there is none, and what to do, in a sentence
    bool odometry_is_old = false;  ///< and may be heard again
  };
  /// `instead`: where odometry's frame is taken to lie in the map while that is not known.
  Found find(std::chrono::nanoseconds now,
             const std::optional<core::Pose2d>& instead = std::nullopt) const;

  /// Places about the robot where it may be, by the belief; without one the nearest place. None of
  /// `unreachable` is among them.
  std::vector<core::RouteStart> starts(const RobotFix& fix,
                                       const std::vector<core::PlaceId>& unreachable) const;

 private:
  std::optional<core::Pose2d> mapFromOdom(std::string& problem) const;

  const config::Parameters& parameters_;
  const tf2::BufferCore& buffer_;
  const core::PlaceMemory& memory_;
  const MapDriver& driver_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_ROBOT_FINDER_H
