#include "node/scan/scan_action_server.h"

#include <algorithm>

#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

constexpr int kQueueLength = 50;

std::uint32_t queueLength(const ros::NodeHandle& names, const std::string& parameter) {
  const int length = names.param(parameter, kQueueLength);
  return static_cast<std::uint32_t>(length < 0 ? kQueueLength : length);
}

// Of actionlib's parameters, the one that is searched for in all namespaces above goes first.
double statusFrequency(const ros::NodeHandle& names) {
  double frequency = 5.0;
  std::string name;
  if (!names.getParam("status_frequency", frequency) &&
      names.searchParam("actionlib_status_frequency", name)) {
    names.getParam(name, frequency);
  }
  return frequency;
}

}  // namespace

void ScanActionServer::initialize() {
  const std::uint32_t sent = queueLength(names_, "actionlib_server_pub_queue_size");
  const std::uint32_t taken = queueLength(names_, "actionlib_server_sub_queue_size");
  results_ = names_.advertise<ActionResult>("result", sent);
  feedback_ = names_.advertise<ActionFeedback>("feedback", sent);
  statuses_ = names_.advertise<actionlib_msgs::GoalStatusArray>("status", sent, true);
  status_list_timeout_ = ros::Duration(names_.param("status_list_timeout", 5.0));
  if (const double frequency = statusFrequency(names_); frequency > 0.0) {
    status_timer_ =
        names_.createSteadyTimer(ros::WallDuration(1.0 / frequency),
                                 [this](const ros::SteadyTimerEvent&) { publishStatus(); });
  }
  goals_ = names_.subscribe("goal", taken, &ScanActionServer::onGoal, this);
  cancels_ = names_.subscribe("cancel", taken, &ScanActionServer::onCancel, this);
}

void ScanActionServer::onGoal(const ActionGoalConstPtr& goal) {
  {
    const boost::recursive_mutex::scoped_lock lock(lock_);
    // Time was set back since that cancel: it says nothing of goals of now.
    if (last_cancel_ > ros::Time::now()) last_cancel_ = ros::Time();
  }
  goalCallback(goal);
}

void ScanActionServer::onCancel(const actionlib_msgs::GoalID::ConstPtr& goal_id) {
  // Everything up to a stamp is canceled, which is what there is up to now.
  const auto until_now = boost::make_shared<actionlib_msgs::GoalID>(*goal_id);
  until_now->stamp = std::min(goal_id->stamp, ros::Time::now());
  cancelCallback(until_now);
}

void ScanActionServer::publishResult(const actionlib_msgs::GoalStatus& status,
                                     const Result& result) {
  const boost::recursive_mutex::scoped_lock lock(lock_);
  ActionResult message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.result = result;
  results_.publish(message);
  publishStatus();
}

void ScanActionServer::publishFeedback(const actionlib_msgs::GoalStatus& status,
                                       const Feedback& feedback) {
  const boost::recursive_mutex::scoped_lock lock(lock_);
  ActionFeedback message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.feedback = feedback;
  feedback_.publish(message);
}

void ScanActionServer::publishStatus() {
  const boost::recursive_mutex::scoped_lock lock(lock_);
  if (!started_) return;
  const ros::Time now = ros::Time::now();
  actionlib_msgs::GoalStatusArray message;
  message.header.stamp = now;
  for (auto goal = status_list_.begin(); goal != status_list_.end();) {
    message.status_list.push_back(goal->status_);
    // A goal that nobody holds any more is shown for a while.
    ros::Time& left = goal->handle_destruction_time_;
    left = std::min(left, now);  // time may have been set back since
    const double shown = toSeconds(toNanoseconds(now) - toNanoseconds(left));
    const bool is_over = !left.isZero() && shown > status_list_timeout_.toSec();
    goal = is_over ? status_list_.erase(goal) : std::next(goal);
  }
  statuses_.publish(message);
}

}  // namespace place_memory::node
