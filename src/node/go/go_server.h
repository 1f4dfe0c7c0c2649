#ifndef PLACE_MEMORY_NODE_GO_GO_SERVER_H
#define PLACE_MEMORY_NODE_GO_GO_SERVER_H

#include <place_memory/GoToPlaceAction.h>
#include <ros/node_handle.h>
#include <ros/time.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "core/drive/goal_run.h"
#include "node/base/action_thread.h"
#include "node/drive/map_driver.h"
#include "node/go/goal_watch.h"
#include "node/go/pilot.h"
#include "node/go/robot_search.h"
#include "node/go/view_asker.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The action ~go_to_place.
///
/// One goal at a time: a newer one ends the one that runs. A goal that makes no sense, or that
/// names no place, is rejected and changes nothing, as is any goal while something else moves the
/// robot. A robot that does not know where it is looks about first. Everything runs on a thread of
/// the server's own.
class GoServer {
 public:
  /// All references must outlive it.
  struct Context {
    core::PlaceMemory& memory;
    const MapDriver& driver;
    const ViewAsker& asker;
    Pilot::Context pilot;
  };

  /// `names` resolves relative names, `private_names` the action.
  GoServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
           const Context& context);
  ~GoServer();
  GoServer(const GoServer&) = delete;
  GoServer& operator=(const GoServer&) = delete;

  /// Ends a goal that runs, and the robot stands. To be called before ros::shutdown().
  void stop();

  /// ROS time ran backwards. Thread-safe.
  void onTimeJump() { watch_.onTimeJump(); }

 private:
  using GoalHandle = ActionThread<GoToPlaceAction>::GoalHandle;

  void onGoal(const GoalHandle& goal);
  void onCancel(const GoalHandle& goal);
  void onError(const std::string& what);
  void update();

  void begin(const core::RouteEnd& end);
  core::RoutePlan plan(const core::GoalRun::Wish& wish) const;
  void report(const core::Traversal& traversal);
  /// Whether something else than the drive ends the goal.
  bool watch(std::chrono::nanoseconds now);
  void drive(std::chrono::nanoseconds now);
  /// It is not known where the robot is: looks about where that is possible, or ends the goal.
  void beginSearch(const std::string& why);
  void search(std::chrono::nanoseconds now);
  void take(const DriveReport& report, std::chrono::nanoseconds now);
  bool isFeedbackDue(DriveReport::State state);
  void sayFeedback(const DriveReport& report);
  void finishIfOver();
  /// `message` by value: the run, which may hold it, ends here.
  void finish(std::uint8_t status, std::string message);

  const Context context_;
  const config::Parameters& parameters_;
  ActionThread<GoToPlaceAction> thread_;
  std::unique_ptr<Pilot> pilot_;
  GoalHandle goal_;  // of run_
  std::optional<core::GoalRun> run_;
  std::optional<RobotSearch> search_;  // of run_, where it was needed
  bool searches_ = false;
  core::RouteEnd end_;             // of run_
  core::GoalRun::Leg driven_;      // that the pilot drives to
  std::uint64_t map_version_ = 0;  // that run_ has followed
  GoalWatch watch_;
  ros::SteadyTime last_feedback_;
  DriveReport::State last_state_ = DriveReport::State::kGoing;  ///< what it does is said at once
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_GO_SERVER_H
