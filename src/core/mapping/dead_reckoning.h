#ifndef PLACE_MEMORY_CORE_MAPPING_DEAD_RECKONING_H
#define PLACE_MEMORY_CORE_MAPPING_DEAD_RECKONING_H

#include <cmath>
#include <optional>

#include "core/map/pose_relaxation.h"

namespace place_memory::core {

/// Odometry with the lasting errors of the wheels taken out, and the way driven. What a robot that
/// stands trembles by is no way.
class DeadReckoning {
 public:
  /// Odometry's next pose.
  void add(const Pose2d& odom_from_base, const OdometryErrors& errors) {
    if (!odom_) odom_ = odom_from_base;
    const Pose2d motion = odom_->inverse() * odom_from_base;
    const double moved = std::hypot(motion.x, motion.y);
    if (moved < kStep && std::abs(motion.yaw) < kTurn) {
      rest_ = motion;
      return;
    }
    // A turn on the spot trembles too.
    const double way = moved < kStep ? 0.0 : moved;
    pose_ = pose_ * errors.corrected(motion, way, motion.yaw);
    way_ += way;
    turn_ += motion.yaw;
    odom_ = odom_from_base;
    rest_ = {};
  }

  Pose2d pose() const { return pose_ * rest_; }
  double way() const { return way_; }
  /// All turns that odometry measured, not wrapped [rad].
  double turn() const { return turn_; }
  /// Odometry starts anew somewhere: pose and way go on from here.
  void restart() {
    odom_.reset();
    pose_ = pose();
    rest_ = {};
  }

 private:
  static constexpr double kStep = 0.02;         // [m]
  static constexpr double kTurn = kPi / 180.0;  // [rad]

  std::optional<Pose2d> odom_;  ///< as of pose_
  Pose2d pose_;
  Pose2d rest_;  ///< since then
  double way_ = 0.0;
  double turn_ = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_DEAD_RECKONING_H
