#include "node/go/pilot.h"

#include "core/sensing/odometry_jump.h"
#include "node/base/ros_time.h"
#include "node/go/move_base_driver.h"
#include "node/go/velocity_driver.h"

namespace place_memory::node {
namespace {

using State = DriveReport::State;

// Odometry that is not heard for a moment is no reason to give up.
constexpr std::chrono::nanoseconds kOdometryPatience = std::chrono::seconds(3);

}  // namespace

Pilot::Pilot(const ros::NodeHandle& names, const Context& context) : context_(context) {
  if (context.parameters.drive.by == config::DriveBy::kMoveBase) {
    driver_ = std::make_unique<MoveBaseDriver>(names, context.parameters);
  } else {
    driver_ = std::make_unique<VelocityDriver>(context.parameters.drive, context.echoes);
  }
}

bool Pilot::take(const std::string& who, std::string& refusal) {
  if (!hold_) hold_ = context_.lease.take(who, refusal);
  return hold_ != nullptr;
}

void Pilot::give() {
  stop();
  hold_.reset();
}

void Pilot::driveTo(const core::Pose2d& target) {
  if (!driving_) {
    fix_.reset();
    odometry_waits_.reset();
  }
  driving_ = true;
  driver_->begin(target, *hold_);
}

void Pilot::moveTarget(const core::Pose2d& target) {
  if (driving_) driver_->moveTarget(target);
}

void Pilot::stop() {
  driver_->stop();
  driving_ = false;
}

DriveReport Pilot::lost(const RobotFinder::Found& found) {
  if (found.odometry_is_old) {
    if (!odometry_waits_) odometry_waits_ = steadyNow();
    driver_->pause();
    if (steadyNow() - *odometry_waits_ < kOdometryPatience) return {State::kWaiting, "", 0.0};
  }
  stop();
  return {found.odometry_is_old ? State::kAdrift : State::kLost, found.problem, 0.0};
}

bool Pilot::hasJumped(const RobotFix& fix) const {
  return fix_ && fix.stamp >= fix_->stamp &&
         core::odometryJumped(fix_->odom_from_base, fix.odom_from_base,
                              toSeconds(fix.stamp - fix_->stamp));
}

DriveReport Pilot::update(std::chrono::nanoseconds now,
                          const std::optional<core::Pose2d>& instead) {
  const RobotFinder::Found found = context_.finder.find(now, instead);
  // What follows the drive may lose the map for a jump before it is seen here.
  const RobotFinder::Found odometry = found.fix ? found : context_.finder.find(now, core::Pose2d{});
  if (odometry.fix && hasJumped(*odometry.fix)) {
    stop();
    return {State::kAdrift,
            "odometry jumped: the robot was carried, or its odometry was reset; scan and recognize "
            "a place, or drive it in mode localize",
            0.0};
  }
  if (!found.fix) return lost(found);
  odometry_waits_.reset();
  fix_ = found.fix;
  const DriveReport report = driver_->update(*fix_, now);
  if (report.isOver()) stop();
  return report;
}

}  // namespace place_memory::node
