#ifndef PLACE_MEMORY_CORE_MEMORY_LINK_POSE_H
#define PLACE_MEMORY_CORE_MEMORY_LINK_POSE_H

#include <array>
#include <chrono>

#include "core/memory/whereabouts.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// The same covariance over x, y, yaw, row-major, in a frame in which its own is turned by `yaw`
/// [rad].
std::array<double, 9> turned(const std::array<double, 9>& covariance, double yaw);

/// The same link with its ends exchanged.
PlaceLink seenFromSecond(const PlaceLink& link);

/// The link that the robot came along: from where it stood to a place that it learned at `arrived`,
/// and that has the higher id. Its pose and covariance are those that PlaceLink states; `located`
/// false: there is no odometry.
PlaceLink linkTo(PlaceId place, const Pose2d& odom_from_place, const Stand& from, bool located,
                 std::chrono::nanoseconds arrived);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_LINK_POSE_H
