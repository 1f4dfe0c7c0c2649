#ifndef PLACE_MEMORY_NODE_BASE_ACTION_THREAD_H
#define PLACE_MEMORY_NODE_BASE_ACTION_THREAD_H

#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/steady_timer.h>

#include <functional>
#include <memory>
#include <string>

#include "node/base/guarded_queue.h"
#include "node/base/steady_action_server.h"

namespace place_memory::node {

/// An action whose goals, cancels and steady ticks come on a thread of its own, one after the
/// other.
template <class Action>
class ActionThread {
 public:
  using Server = SteadyActionServer<Action>;
  using GoalHandle = typename Server::GoalHandle;

  struct Callbacks {
    typename Server::OnGoal goal;
    typename Server::OnGoal cancel;
    std::function<void()> tick;
    std::function<void(const std::string& what)> error;  ///< one of the others threw
  };

  /// `names` resolves relative names, `private_names` that of the action. Nothing comes before
  /// start().
  ActionThread(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
               const std::string& action, const ros::WallDuration& period,
               const Callbacks& callbacks)
      : queue_(action, callbacks.error), names_(names), private_names_(private_names) {
    names_.setCallbackQueue(&queue_);
    private_names_.setCallbackQueue(&queue_);
    server_ = std::make_unique<Server>(ros::NodeHandle(private_names_, action), callbacks.goal,
                                       callbacks.cancel);
    const auto tick = callbacks.tick;
    timer_ = names_.createSteadyTimer(period, [tick](const ros::SteadyTimerEvent&) { tick(); });
  }

  void start() {
    server_->start();
    spinner_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
    spinner_->start();
  }

  /// No callback runs any more. Whether one could until now.
  bool halt() {
    if (!spinner_) return false;
    spinner_->stop();
    spinner_.reset();
    timer_.stop();
    return true;
  }

  /// After halt(), and without a goal handle that is left.
  void close() {
    server_.reset();
    queue_.clear();
  }

  /// What is subscribed to by it is heard on the thread.
  ros::NodeHandle& names() { return names_; }

 private:
  GuardedQueue queue_;
  ros::NodeHandle names_;
  ros::NodeHandle private_names_;
  std::unique_ptr<Server> server_;
  ros::SteadyTimer timer_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_ACTION_THREAD_H
