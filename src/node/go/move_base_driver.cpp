#include "node/go/move_base_driver.h"

#include <ros/this_node.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "node/base/conversions.h"
#include "node/base/ros_time.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

using State = DriveReport::State;
using Status = actionlib_msgs::GoalStatus;

// Further off than that from where it was to drive, it is not there, whatever the server says.
constexpr double kThere = 0.75;  // [m]
// A target that moved less is the same: each new goal has the server plan anew.
constexpr double kMoved = 0.3;  // [m]

double between(const core::Pose2d& one, const core::Pose2d& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

std::string metres(double distance) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f m", distance);
  return text;
}

}  // namespace

MoveBaseDriver::MoveBaseDriver(const ros::NodeHandle& names, const config::Parameters& parameters)
    : parameters_(parameters), names_(names, kMoveBaseName) {
  names_.setCallbackQueue(names.getCallbackQueue());
  goals_ = names_.advertise<move_base_msgs::MoveBaseActionGoal>("goal", 5);
  cancels_ = names_.advertise<actionlib_msgs::GoalID>("cancel", 5);
  statuses_ = names_.subscribe("status", 5, &MoveBaseDriver::onStatus, this);
  results_ = names_.subscribe("result", 5, &MoveBaseDriver::onResult, this);
}

MoveBaseDriver::~MoveBaseDriver() { stop(); }

void MoveBaseDriver::begin(const core::Pose2d& target, DriveLease::Hold& hold) {
  cancel();
  hold_ = &hold;
  target_ = target;
  heard_ = steadyNow();
}

void MoveBaseDriver::moveTarget(const core::Pose2d& target) {
  if (!target_ || between(*target_, target) < kMoved) return;
  begin(target, *hold_);
}

void MoveBaseDriver::stop() {
  cancel();
  target_.reset();
  hold_ = nullptr;
}

void MoveBaseDriver::cancel() {
  if (!id_.empty() && !result_) {
    actionlib_msgs::GoalID id;
    id.id = id_;
    cancels_.publish(id);
  }
  id_.clear();
  result_.reset();
}

void MoveBaseDriver::send(const RobotFix& fix, std::chrono::nanoseconds now) {
  move_base_msgs::MoveBaseActionGoal message;
  message.header.stamp = toRosTime(now);
  message.goal_id.stamp = message.header.stamp;
  id_ = ros::this_node::getName() + "-" + std::to_string(++sent_) + "-" +
        std::to_string(steadyNow().count());
  message.goal_id.id = id_;
  core::Pose2d pose = *target_;
  const core::Pose2d& robot = fix.map_from_base;
  pose.yaw =
      between(pose, robot) > kMoved ? std::atan2(pose.y - robot.y, pose.x - robot.x) : robot.yaw;
  message.goal.target_pose.header = makeHeader(parameters_.map_frame, message.header.stamp);
  message.goal.target_pose.pose = toPose(pose);
  goals_.publish(message);
}

void MoveBaseDriver::onStatus(const actionlib_msgs::GoalStatusArray& message) {
  const bool knows = std::any_of(message.status_list.begin(), message.status_list.end(),
                                 [this](const Status& each) { return each.goal_id.id == id_; });
  if (knows) heard_ = steadyNow();
}

void MoveBaseDriver::onResult(const move_base_msgs::MoveBaseActionResult& message) {
  if (!id_.empty() && message.status.goal_id.id == id_) result_ = message.status;
}

DriveReport MoveBaseDriver::update(const RobotFix& fix, std::chrono::nanoseconds now) {
  const double distance = between(*target_, fix.map_from_base);
  if (id_.empty() && goals_.getNumSubscribers() > 0) send(fix, now);
  if (result_) return ended(distance);
  if (toSeconds(steadyNow() - heard_) > parameters_.drive.timeout) return silent(distance);
  return {State::kGoing, "", distance};
}

DriveReport MoveBaseDriver::ended(double distance) const {
  const std::string server = names_.getNamespace();
  const std::string said = result_->text.empty() ? "" : " (" + result_->text + ")";
  switch (result_->status) {
    case Status::SUCCEEDED:
      if (distance <= kThere) return {State::kArrived, "", distance};
      return {State::kBlocked,
              server + " says that it is there, but by the map it is " + metres(distance) +
                  " off: does it go by the same map?",
              distance};
    case Status::PREEMPTED:
    case Status::RECALLED:
      return {State::kPreempted, "somebody else drives the robot through " + server + said,
              distance};
    case Status::REJECTED:
      return {State::kBlocked, server + " rejects the goal" + said, distance};
    default:
      return {State::kBlocked, server + " gives it up" + said, distance};
  }
}

DriveReport MoveBaseDriver::silent(double distance) {
  hold_->drive(0.0, 0.0);  // nobody else may be there to stop it
  const std::string wait = inSeconds(toNanoseconds(parameters_.drive.timeout));
  const std::string server = names_.getNamespace();
  return {State::kSilent,
          id_.empty() ? "nothing listens on " + server + "/goal for " + wait +
                            ": start the server, remap move_base, or set drive/by to cmd_vel"
                      : server + " has said nothing of the goal for " + wait + ": does it run?",
          distance};
}

}  // namespace place_memory::node
