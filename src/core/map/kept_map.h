#ifndef PLACE_MEMORY_CORE_MAP_KEPT_MAP_H
#define PLACE_MEMORY_CORE_MAP_KEPT_MAP_H

#include <Eigen/Core>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/map/pose_relaxation.h"
#include "place_memory/core/place_id.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

using NodeIndex = std::size_t;

/// A moving scan as a node of the graph. Its pose is the base's at the middle of its stretch.
struct ScanNode {
  std::chrono::nanoseconds stamp{0};
  Pose2d odom_from_base;
  double first_way = 0.0;  ///< ends of its stretch of the way [m]
  double last_way = 0.0;
  int session = 0;  ///< in whose frame its pose lies
  Pose2d pose;
  std::optional<NodeIndex> before;  ///< that odometry came from
  Pose2d motion;                    ///< from there, as odometry measured it
  double motion_way = 0.0;          ///< [m]
  double motion_turn = 0.0;         ///< not wrapped [rad]
  std::optional<double> compass;    ///< heading that it showed [rad]
  std::shared_ptr<const std::vector<SonarReading>> readings;  ///< in its frame
  PlaceId place = kNoPlace;                                   ///< that it is
  double laid_yaw = 0.0;  ///< heading in the map for which its grid was laid out [rad]
  /// Middle of what its readings show, in its frame; yaw 0. It follows from the readings.
  Pose2d seen;

  /// Whether what it shows lies before it, not about it.
  bool looksAhead() const { return seen.x != 0.0 || seen.y != 0.0; }
};

/// A node as it was matched to a place.
struct Tie {
  NodeIndex place = 0;  ///< node of the place
  NodeIndex node = 0;
  Pose2d relative;              ///< of the node in the place's frame
  Eigen::Matrix3d information;  ///< of that
  int closure = 0;              ///< of which loop closure; 0: a tracked match
};

/// A map as it is kept: nodes that are places have their readings; of a map without scans between
/// places, or without ties, the rest is empty.
struct KeptMap {
  std::vector<ScanNode> nodes;
  std::vector<Tie> ties;
  OdometryErrors errors;
  PlaceId next_place = 1;  ///< ids from here on were never given
  /// Places that a person learned or named: none goes because it seems doubled.
  std::vector<PlaceId> named;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_KEPT_MAP_H
