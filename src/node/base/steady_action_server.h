#ifndef PLACE_MEMORY_NODE_BASE_STEADY_ACTION_SERVER_H
#define PLACE_MEMORY_NODE_BASE_STEADY_ACTION_SERVER_H

#include <actionlib/server/action_server_base.h>
#include <ros/node_handle.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>

#include "node/base/ros_time.h"

namespace place_memory::node {
namespace detail {

constexpr int kActionQueueLength = 50;

inline std::uint32_t queueLength(const ros::NodeHandle& names, const std::string& parameter) {
  const int length = names.param(parameter, kActionQueueLength);
  return static_cast<std::uint32_t>(length < 0 ? kActionQueueLength : length);
}

// Of actionlib's parameters, the one that is searched for in all namespaces above goes first.
inline double statusFrequency(const ros::NodeHandle& names) {
  double frequency = 5.0;
  std::string name;
  if (!names.getParam("status_frequency", frequency) &&
      names.searchParam("actionlib_status_frequency", name)) {
    names.getParam(name, frequency);
  }
  return frequency;
}

}  // namespace detail

/// The protocol of an action, for any ROS time and any stamp of a client.
///
/// actionlib's own ActionServer adds up stamps without looking, which throws where one is near the
/// end of what it holds, for good where a cancel is so stamped; publishes its status by ROS time,
/// which may stand still; and refuses every goal after a cancel from the future.
template <class Action>
class SteadyActionServer : public actionlib::ActionServerBase<Action> {
 public:
  ACTION_DEFINITION(Action)
  using GoalHandle = typename actionlib::ActionServerBase<Action>::GoalHandle;
  using OnGoal = boost::function<void(GoalHandle)>;

  /// Takes messages once start() was called. `names`: of the action.
  SteadyActionServer(const ros::NodeHandle& names, const OnGoal& on_goal, const OnGoal& on_cancel)
      : actionlib::ActionServerBase<Action>(on_goal, on_cancel), names_(names) {}

 protected:
  void initialize() override;
  void publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) override;
  void publishFeedback(const actionlib_msgs::GoalStatus& status, const Feedback& feedback) override;
  void publishStatus() override;

 private:
  void onGoal(const ActionGoalConstPtr& goal);
  void onCancel(const actionlib_msgs::GoalID::ConstPtr& goal_id);

  ros::NodeHandle names_;
  ros::Subscriber goals_;
  ros::Subscriber cancels_;
  ros::Publisher statuses_;
  ros::Publisher results_;
  ros::Publisher feedback_;
  ros::SteadyTimer status_timer_;
};

template <class Action>
void SteadyActionServer<Action>::initialize() {
  const std::uint32_t sent = detail::queueLength(names_, "actionlib_server_pub_queue_size");
  const std::uint32_t taken = detail::queueLength(names_, "actionlib_server_sub_queue_size");
  results_ = names_.advertise<ActionResult>("result", sent);
  feedback_ = names_.advertise<ActionFeedback>("feedback", sent);
  statuses_ = names_.advertise<actionlib_msgs::GoalStatusArray>("status", sent, true);
  this->status_list_timeout_ = ros::Duration(names_.param("status_list_timeout", 5.0));
  if (const double frequency = detail::statusFrequency(names_); frequency > 0.0) {
    status_timer_ =
        names_.createSteadyTimer(ros::WallDuration(1.0 / frequency),
                                 [this](const ros::SteadyTimerEvent&) { publishStatus(); });
  }
  goals_ = names_.subscribe("goal", taken, &SteadyActionServer::onGoal, this);
  cancels_ = names_.subscribe("cancel", taken, &SteadyActionServer::onCancel, this);
}

template <class Action>
void SteadyActionServer<Action>::onGoal(const ActionGoalConstPtr& goal) {
  {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    // Time was set back since that cancel: it says nothing of goals of now.
    if (this->last_cancel_ > ros::Time::now()) this->last_cancel_ = ros::Time();
  }
  this->goalCallback(goal);
}

template <class Action>
void SteadyActionServer<Action>::onCancel(const actionlib_msgs::GoalID::ConstPtr& goal_id) {
  // Everything up to a stamp is canceled, which is what there is up to now.
  const auto until_now = boost::make_shared<actionlib_msgs::GoalID>(*goal_id);
  until_now->stamp = std::min(goal_id->stamp, ros::Time::now());
  this->cancelCallback(until_now);
}

template <class Action>
void SteadyActionServer<Action>::publishResult(const actionlib_msgs::GoalStatus& status,
                                               const Result& result) {
  const boost::recursive_mutex::scoped_lock lock(this->lock_);
  ActionResult message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.result = result;
  results_.publish(message);
  publishStatus();
}

template <class Action>
void SteadyActionServer<Action>::publishFeedback(const actionlib_msgs::GoalStatus& status,
                                                 const Feedback& feedback) {
  const boost::recursive_mutex::scoped_lock lock(this->lock_);
  ActionFeedback message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.feedback = feedback;
  feedback_.publish(message);
}

template <class Action>
void SteadyActionServer<Action>::publishStatus() {
  const boost::recursive_mutex::scoped_lock lock(this->lock_);
  if (!this->started_) return;
  const ros::Time now = ros::Time::now();
  actionlib_msgs::GoalStatusArray message;
  message.header.stamp = now;
  for (auto goal = this->status_list_.begin(); goal != this->status_list_.end();) {
    message.status_list.push_back(goal->status_);
    // A goal that nobody holds any more is shown for a while.
    ros::Time& left = goal->handle_destruction_time_;
    left = std::min(left, now);  // time may have been set back since
    const double shown = toSeconds(toNanoseconds(now) - toNanoseconds(left));
    const bool is_over = !left.isZero() && shown > this->status_list_timeout_.toSec();
    goal = is_over ? this->status_list_.erase(goal) : std::next(goal);
  }
  statuses_.publish(message);
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_STEADY_ACTION_SERVER_H
