#ifndef PLACE_MEMORY_CORE_SENSING_ODOMETRY_JUMP_H
#define PLACE_MEMORY_CORE_SENSING_ODOMETRY_JUMP_H

#include <cmath>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Whether odometry moved further than the noise and speed of a fast robot explain (0.3 m and 3
/// m/s, 20 degrees and a turn a second): it was reset. `seconds` >= 0 lie between the two poses.
inline bool odometryJumped(const Pose2d& before, const Pose2d& after, double seconds) {
  const double moved = std::hypot(after.x - before.x, after.y - before.y);
  const double turned = std::abs(wrapAngle(after.yaw - before.yaw));
  return moved > 0.3 + 3.0 * seconds || turned > kPi / 9.0 + 2.0 * kPi * seconds;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_ODOMETRY_JUMP_H
