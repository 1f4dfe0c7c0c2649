#include "sim/robot/simulated_base.h"

namespace place_memory::sim {

SimulatedBase::SimulatedBase(const core::Pose2d& start, double radius, const OdometryDrift& drift,
                             Rng& rng)
    : truth_(start),
      radius_(radius),
      distance_scale_(1.0 + drift.distance * normal(rng)),
      turn_scale_(1.0 + drift.turn * normal(rng)),
      turn_per_metre_(drift.turn_per_metre * normal(rng)) {}

bool SimulatedBase::step(double forward, double turn, double dt, const Scene& scene) {
  const double half_turn = 0.5 * turn * dt;
  const double distance = forward * dt;
  const core::Pose2d half{0.0, 0.0, half_turn};
  core::Pose2d moved = truth_ * half * core::Pose2d{distance, 0.0, 0.0} * half;
  // A base that already touches something may still drive away from it.
  const bool blocked = distance != 0.0 && scene.isFree({truth_.x, truth_.y}, radius_) &&
                       !scene.isFree({moved.x, moved.y}, radius_);
  if (blocked) moved = truth_ * half * half;
  truth_ = moved;
  const double believed = blocked ? 0.0 : distance * distance_scale_;
  const core::Pose2d believed_half{0.0, 0.0,
                                   half_turn * turn_scale_ + 0.5 * turn_per_metre_ * believed};
  odometry_ = odometry_ * believed_half * core::Pose2d{believed, 0.0, 0.0} * believed_half;
  return !blocked;
}

}  // namespace place_memory::sim
