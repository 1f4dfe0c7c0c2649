#ifndef PLACE_MEMORY_RVIZ_ACTION_LINK_H
#define PLACE_MEMORY_RVIZ_ACTION_LINK_H

#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/subscriber.h>
#include <ros/this_node.h>
#include <ros/time.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "rviz/action_words.h"
#include "rviz/board.h"

namespace place_memory::panel {

/// Goals of one action of a node, by its topics: an action client of ROS sees its own goals alone,
/// and a person wants to see what the robot does, whoever asked for it.
template <class Action>
class ActionLink {
 public:
  using ActionGoal = typename Action::_action_goal_type;
  using ActionFeedback = typename Action::_action_feedback_type;
  using ActionResult = typename Action::_action_result_type;
  using Goal = typename ActionGoal::_goal_type;

  /// `name`: of the action below that of the node.
  ActionLink(ros::NodeHandle& names, const std::string& node, const std::string& name,
             const std::shared_ptr<Board>& board)
      : name_(name), board_(board) {
    const std::string topic = node + "/" + name;
    goal_ = names.advertise<ActionGoal>(
        topic + "/goal", 1,
        [this](const ros::SingleSubscriberPublisher& server) { onConnected(server); });
    cancel_ = names.advertise<actionlib_msgs::GoalID>(topic + "/cancel", 1);
    subscribers_ = {names.subscribe(topic + "/status", 10, &ActionLink::onStatus, this),
                    names.subscribe(topic + "/feedback", 10, &ActionLink::onFeedback, this),
                    names.subscribe(topic + "/result", 10, &ActionLink::onResult, this)};
  }

  void send(const Goal& goal) {
    ActionGoal message;
    message.goal_id.id = ros::this_node::getName() + "-" + name_ + "-" +
                         std::to_string(Clock::now().time_since_epoch().count());
    message.goal = goal;
    board_->change(
        [&](PanelState& state) { state.sendGoal(name_, message.goal_id.id, Clock::now()); });
    const std::lock_guard<std::mutex> lock(mutex_);
    if (goal_.getNumSubscribers() > 0) {
      goal_.publish(message);
    } else {
      unsent_ = {message, Clock::now()};
    }
  }

  /// Whatever goal is under way.
  void cancel() { cancel_.publish(actionlib_msgs::GoalID()); }

 private:
  using Clock = std::chrono::steady_clock;

  /// A goal and when it was asked for, where the node was not connected yet.
  struct Unsent {
    ActionGoal goal;
    Clock::time_point since;
  };

  void onConnected(const ros::SingleSubscriberPublisher& server) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (unsent_ && Clock::now() - unsent_->since < kGoalPatience) server.publish(unsent_->goal);
    unsent_.reset();
  }

  void onStatus(const actionlib_msgs::GoalStatusArray& statuses) {
    board_->change([&](PanelState& state) { state.hearStatuses(name_, statuses, Clock::now()); });
  }

  void onFeedback(const ActionFeedback& message) {
    board_->change([&](PanelState& state) {
      state.hearProgress(name_, message.status.goal_id.id, progressOf(message.feedback),
                         Clock::now());
    });
  }

  void onResult(const ActionResult& message) {
    board_->change([&](PanelState& state) {
      state.endGoal(name_, message.status.goal_id.id, name_ + ": " + message.result.message,
                    message.status.status != actionlib_msgs::GoalStatus::SUCCEEDED);
    });
  }

  const std::string name_;
  const std::shared_ptr<Board> board_;
  ros::Publisher goal_;
  std::mutex mutex_;
  std::optional<Unsent> unsent_;
  ros::Publisher cancel_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_ACTION_LINK_H
