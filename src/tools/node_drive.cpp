#include "tools/node_drive.h"

#include <actionlib/client/simple_action_client.h>
#include <place_memory/GoToPlaceAction.h>
#include <ros/time.h>

#include <csignal>
#include <mutex>

#include "node/names/node_names.h"

namespace place_memory::tools {
namespace {

using Result = GoToPlaceResult;

const ros::WallDuration kPatience(
    5.0);  // until the action is there, or a goal that is canceled ends
const ros::WallDuration kPeriod(0.05);

volatile std::sig_atomic_t interrupted = 0;

void onInterrupt(int /*signal*/) { interrupted = 1; }

/// Until it is destroyed SIGINT is noted, and ends nothing.
class InterruptWatch {
 public:
  InterruptWatch() : before_(std::signal(SIGINT, onInterrupt)) { interrupted = 0; }
  ~InterruptWatch() { std::signal(SIGINT, before_); }
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  void (*before_)(int);
};

/// By the wall's clock, because simulated time may stand still. Returns whether it holds.
template <class Condition>
bool wait(const ros::WallDuration& patience, const Condition& condition) {
  const ros::WallTime end = ros::WallTime::now() + patience;
  while (!condition()) {
    if (ros::WallTime::now() > end) return false;
    kPeriod.sleep();
  }
  return true;
}

DrivenGoal::End endOf(std::uint8_t status) {
  switch (status) {
    case Result::REACHED:
      return DrivenGoal::End::kReached;
    case Result::NO_ROUTE:
    case Result::UNKNOWN_GOAL:
      return DrivenGoal::End::kNoWay;
    default:
      return DrivenGoal::End::kFailed;
  }
}

/// Says what the robot does whenever that changes.
class Reporter {
 public:
  explicit Reporter(const Progress& progress) : progress_(progress) {}

  void take(const GoToPlaceFeedback& feedback) {
    const std::string sentence =
        feedback.leg.empty() ? feedback.message : feedback.leg + ": " + feedback.message;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (sentence != said_) progress_(sentence);
    said_ = sentence;
  }

 private:
  const Progress& progress_;
  std::mutex mutex_;
  std::string said_;
};

}  // namespace

DrivenGoal driveTo(const std::string& node, const std::string& label, const Progress& progress) {
  const std::string action = node + "/" + place_memory::node::kGoToPlaceAction;
  Reporter reporter(progress);
  actionlib::SimpleActionClient<GoToPlaceAction> client(action, true);
  const auto is_there = [&] { return client.isServerConnected(); };
  if (!wait(kPatience, is_there)) {
    throw CommandError(
        "there is no action " + action + ": is the node running, and called " + node + "?",
        kNoAnswer);
  }
  const InterruptWatch watch;
  GoToPlaceGoal goal;
  goal.label = label;
  client.sendGoal(goal, {}, {},
                  [&](const GoToPlaceFeedbackConstPtr& feedback) { reporter.take(*feedback); });
  const auto is_over = [&] { return client.getState().isDone(); };
  while (!is_over()) {
    if (interrupted != 0) {
      client.cancelGoal();
      if (!wait(kPatience, is_over)) throw CommandError("the node did not cancel it", kNoAnswer);
    } else if (!is_there()) {
      throw CommandError("the node is gone", kNoAnswer);
    }
    kPeriod.sleep();
  }
  const auto result = client.getResult();
  return {endOf(result->status), result->message};
}

}  // namespace place_memory::tools
