#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_SERVER_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_SERVER_H

#include <actionlib/server/action_server.h>
#include <place_memory/ScanPlaceAction.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/sensing/sweep_turner.h"
#include "node/scan/scan_collector.h"
#include "node/scan/scan_goal.h"

namespace place_memory::node {

/// The scan that a goal asked for.
struct Sweep {
  ScanRequest request;
  ros::Time started;  // 0 until simulated time runs
  std::optional<core::SweepTurner> turner;
  std::size_t readings = 0;  // used when last_reading was
  ros::Time last_reading;
};

/// The action ~scan, and the subscriptions it needs.
///
/// One scan at a time: a newer goal ends the one that runs, which its client is told as CANCELED.
/// Everything runs on a thread of the server's own, and nothing there waits, so that a cancel
/// always comes through. While it turns the robot it publishes a velocity twenty times a second and
/// a zero one whenever a scan ends; should the node die, the robot's driver stops it by its own
/// timeout.
class ScanServer {
 public:
  /// Called on the server's thread, where nothing should wait long. Any may be empty.
  struct Callbacks {
    std::function<void(std::shared_ptr<const core::Scan>)> finished;  ///< a scan succeeded
    std::function<void(const core::Scan&)> partial;  ///< it grows, at most twice a second
    std::function<void()> time_jump;                 ///< time ran backwards; tf is already cleared
  };

  /// `names` resolves relative topics, `private_names` the action. The other arguments must outlive
  /// the server.
  ScanServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
             const config::Parameters& parameters, tf2_ros::Buffer& buffer, Callbacks callbacks);
  ~ScanServer();
  ScanServer(const ScanServer&) = delete;
  ScanServer& operator=(const ScanServer&) = delete;

  /// Ends a scan that runs, stops the robot, and takes no more messages. To be called before
  /// ros::shutdown(), after which no zero velocity gets out.
  void stop();

  /// By frame_id, as it is now. Thread-safe.
  std::map<std::string, SensorHealth> health() const;

 private:
  // Not the simple one: after time ran backwards that refuses every goal until time has caught up.
  using Server = actionlib::ActionServer<ScanPlaceAction>;

  void onGoal(const Server::GoalHandle& goal);
  void onCancel(const Server::GoalHandle& goal);
  void onRange(const sensor_msgs::Range::ConstPtr& message);
  void onHeading(const sensor_msgs::Imu::ConstPtr& message);

  void update(const ros::SteadyTimerEvent& event);
  bool timeRanBackwards(const ros::Time& now);
  bool clockStands(const ros::Time& now);
  void start(const ros::Time& now);
  void listen(const ros::Time& now);
  void turn(const ros::Time& now);
  std::optional<double> yawNow(const ros::Time& now) const;
  void report(const ros::Time& now);
  void timeOut(const ros::Time& now);
  void end(const ScanOutcome& outcome, const ros::Time& now);
  void command(double rate);

  const config::Parameters& parameters_;
  tf2_ros::Buffer& buffer_;
  const Callbacks callbacks_;

  mutable std::mutex mutex_;  // guards collector_'s health
  ScanCollector collector_;
  std::optional<Sweep> sweep_;
  bool moving_ = false;
  ros::Time clock_;
  ros::SteadyTime clock_changed_;
  ros::SteadyTime last_feedback_;
  ros::SteadyTime next_partial_;

  ros::CallbackQueue queue_;
  ros::NodeHandle names_;
  ros::NodeHandle private_names_;
  ros::Publisher command_publisher_;
  std::unique_ptr<Server> server_;
  Server::GoalHandle goal_;  // of sweep_
  std::vector<ros::Subscriber> subscribers_;
  ros::SteadyTimer timer_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_SERVER_H
