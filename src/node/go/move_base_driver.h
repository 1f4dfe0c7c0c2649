#ifndef PLACE_MEMORY_NODE_GO_MOVE_BASE_DRIVER_H
#define PLACE_MEMORY_NODE_GO_MOVE_BASE_DRIVER_H

#include <actionlib_msgs/GoalStatusArray.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "node/go/spot_driver.h"

namespace place_memory::node {

/// Has a server of MoveBaseAction drive, as move_base. Speaks the action's protocol itself: it
/// never waits, and what it takes for silence does not depend on simulated time.
class MoveBaseDriver : public SpotDriver {
 public:
  /// `names`: with the queue of the thread on which everything is called; the action is
  /// `move_base` below it, as it is remapped. `parameters` must outlive it.
  MoveBaseDriver(const ros::NodeHandle& names, const config::Parameters& parameters);
  ~MoveBaseDriver() override;

  void begin(const core::Pose2d& target, DriveLease::Hold& hold) override;
  void moveTarget(const core::Pose2d& target) override;
  DriveReport update(const RobotFix& fix, std::chrono::nanoseconds now) override;
  void pause() override {}
  void stop() override;

 private:
  void send(const RobotFix& fix, std::chrono::nanoseconds now);
  void cancel();
  void onStatus(const actionlib_msgs::GoalStatusArray& message);
  void onResult(const move_base_msgs::MoveBaseActionResult& message);
  DriveReport ended(double distance) const;
  DriveReport silent(double distance);

  const config::Parameters& parameters_;
  ros::NodeHandle names_;
  ros::Publisher goals_;
  ros::Publisher cancels_;
  ros::Subscriber statuses_;
  ros::Subscriber results_;

  DriveLease::Hold* hold_ = nullptr;
  std::optional<core::Pose2d> target_;
  std::string id_;                     // of the goal that was sent; empty: none is under way
  std::chrono::nanoseconds heard_{0};  // when the server spoke of it last, steady
  std::uint64_t sent_ = 0;             // goals
  std::optional<actionlib_msgs::GoalStatus> result_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_MOVE_BASE_DRIVER_H
