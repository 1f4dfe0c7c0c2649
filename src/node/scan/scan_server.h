#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_SERVER_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_SERVER_H

#include <place_memory/ScanPlaceAction.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/steady_timer.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/sensing/clock_watch.h"
#include "node/base/drive_lease.h"
#include "node/base/guarded_queue.h"
#include "node/base/steady_action_server.h"
#include "node/input/message_intake.h"
#include "node/input/raw_message.h"
#include "node/input/sensor_registry.h"
#include "node/input/transform_input.h"
#include "node/scan/input_diagnostics.h"
#include "node/scan/scan_collector.h"
#include "node/scan/sweep.h"

namespace place_memory::node {

/// The action ~scan, and the subscriptions it needs.
///
/// One scan at a time: a newer goal ends the one that runs, which its client is told as CANCELED.
/// A goal that makes no sense is rejected and changes nothing, as is one that asks for the robot to
/// be turned while something else moves it. Everything runs on a thread of the server's own, and
/// nothing there waits, so that a cancel always comes through. While it turns the robot it
/// publishes a velocity twenty times a second and a zero one whenever a scan ends; should the node
/// die, the robot's driver stops it by its own timeout.
class ScanServer {
 public:
  /// Called on the server's thread, where nothing should wait long. Any may be empty.
  struct Callbacks {
    std::function<void(std::shared_ptr<const core::Scan>)> finished;  ///< a scan succeeded
    std::function<void(const core::Scan&)> partial;  ///< it grows, at most twice a second
    std::function<void(bool)> under_way;             ///< one began, or none runs any more
    std::function<void()> time_jump;          ///< ROS time ran backwards; tf is already cleared
    std::function<void(const Taken&)> taken;  ///< what a message said, scan or no scan
  };

  /// `names` resolves relative topics, `private_names` the action. The other arguments must outlive
  /// the server.
  ScanServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
             const config::Parameters& parameters, DriveLease& lease, tf2::BufferCore& buffer,
             TransformInput& transforms, Callbacks callbacks);
  ~ScanServer();
  ScanServer(const ScanServer&) = delete;
  ScanServer& operator=(const ScanServer&) = delete;

  /// Ends a scan that runs, stops the robot, and takes no more messages. To be called before
  /// ros::shutdown(), after which no zero velocity gets out.
  void stop();

  /// How drivers say that no echo came, from the next message on. Thread-safe.
  void setNoEcho(const config::NoEchoOptions& options);

  /// How what it listens to is now. Thread-safe.
  InputHealth health() const;

 private:
  using ActionServer = SteadyActionServer<ScanPlaceAction>;
  using GoalHandle = ActionServer::GoalHandle;

  void subscribe();
  void onGoal(const GoalHandle& goal);
  void onCancel(const GoalHandle& goal);
  void onMessage(const std::string& topic, const RawMessage& message);
  void onError(const std::string& what);

  void update(const ros::SteadyTimerEvent& event);
  void advance(std::chrono::nanoseconds now);
  bool timeRanBackwards(std::chrono::nanoseconds now);
  void sayProblems();
  void report(std::chrono::nanoseconds now);
  void fail(ScanStatus status, const std::string& message, std::chrono::nanoseconds now);
  void end(ScanOutcome outcome, std::chrono::nanoseconds now);

  const config::Parameters& parameters_;
  const config::Parameters named_parameters_;  // with the topics as people remapped them
  DriveLease& lease_;
  tf2::BufferCore& buffer_;
  TransformInput& transforms_;
  const Callbacks callbacks_;

  mutable std::mutex
      mutex_;  // guards the registry, the intake, and what the collector knows of health
  SensorRegistry registry_;
  config::Parameters intake_parameters_;
  MessageIntake intake_;
  ScanCollector collector_;
  std::optional<Sweep> sweep_;
  std::unique_ptr<DriveLease::Hold> hold_;  // of a scan that turns the robot
  core::ClockWatch clock_;
  ros::SteadyTime last_feedback_;
  ros::SteadyTime next_partial_;
  ros::SteadyTime next_warning_;

  GuardedQueue queue_;
  ros::NodeHandle names_;
  ros::NodeHandle private_names_;
  std::unique_ptr<ActionServer> server_;
  GoalHandle goal_;  // of sweep_
  std::vector<ros::Subscriber> subscribers_;
  ros::SteadyTimer timer_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_SERVER_H
