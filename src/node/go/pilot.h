#ifndef PLACE_MEMORY_NODE_GO_PILOT_H
#define PLACE_MEMORY_NODE_GO_PILOT_H

#include <ros/node_handle.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "node/base/drive_lease.h"
#include "node/go/echo_listener.h"
#include "node/go/robot_finder.h"
#include "node/go/spot_driver.h"

namespace place_memory::node {

/// Who owns one drives the robot: takes the lease of it, and has it driven to one spot of the map
/// after the other by what drive/by says. For one thread, that of the queue it is given.
class Pilot {
 public:
  /// All references must outlive it.
  struct Context {
    const config::Parameters& parameters;
    DriveLease& lease;
    EchoListener& echoes;
    const RobotFinder& finder;
  };

  /// `names`: with the queue of the thread on which everything is called.
  Pilot(const ros::NodeHandle& names, const Context& context);

  /// `who`: for people, as "a goal of ~go_to_place". False: something else moves the robot, which
  /// `refusal` says. True again where it has the lease already.
  bool take(const std::string& who, std::string& refusal);
  /// The robot stands, and is others' to move.
  void give();

  /// Needs the lease. A target on the way to another one takes its place.
  void driveTo(const core::Pose2d& target);
  /// The same target, where the map has it now.
  void moveTarget(const core::Pose2d& target);
  /// To be called some twenty times a second while there is a target. Once it is over there is
  /// none, and the robot stands.
  /// `instead`: as RobotFinder::find() takes it.
  DriveReport update(std::chrono::nanoseconds now,
                     const std::optional<core::Pose2d>& instead = std::nullopt);
  /// The robot stands; there is no target any more.
  void stop();
  bool isDriving() const { return driving_; }

  /// Where the robot is, at the newest update; nothing: it was not known.
  const std::optional<RobotFix>& fix() const { return fix_; }

 private:
  DriveReport lost(const RobotFinder::Found& found);
  bool hasJumped(const RobotFix& fix) const;

  const Context context_;
  std::unique_ptr<DriveLease::Hold> hold_;
  std::unique_ptr<SpotDriver> driver_;
  bool driving_ = false;
  std::optional<RobotFix> fix_;
  std::optional<std::chrono::nanoseconds> odometry_waits_;  // since, steady
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_PILOT_H
