#ifndef PLACE_MEMORY_NODE_GO_EXPLORE_SERVER_H
#define PLACE_MEMORY_NODE_GO_EXPLORE_SERVER_H

#include <place_memory/ExploreAction.h>
#include <ros/node_handle.h>
#include <ros/time.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "node/base/action_thread.h"
#include "node/drive/map_driver.h"
#include "node/go/explore_run.h"
#include "node/go/goal_watch.h"
#include "node/go/pilot.h"
#include "node/go/survey_feed.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The action ~explore.
///
/// One goal at a time: a newer one ends the one that runs. A goal out of range is rejected and
/// changes nothing, as is any goal while the node does not map or something else moves the robot.
/// Everything, decisions too, runs on a thread of the server's own.
class ExploreServer {
 public:
  /// All references must outlive it.
  struct Context {
    core::PlaceMemory& memory;
    const MapDriver& driver;
    SurveyFeed& feed;
    Pilot::Context pilot;
  };

  /// `names` resolves relative names, `private_names` the action.
  ExploreServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                const Context& context);
  ~ExploreServer();
  ExploreServer(const ExploreServer&) = delete;
  ExploreServer& operator=(const ExploreServer&) = delete;

  /// Ends a goal that runs, and the robot stands. To be called before ros::shutdown().
  void stop();

  /// ROS time ran backwards. Thread-safe.
  void onTimeJump() { watch_.onTimeJump(); }

 private:
  using GoalHandle = ActionThread<ExploreAction>::GoalHandle;

  void onGoal(const GoalHandle& goal);
  void onCancel(const GoalHandle& goal);
  void onError(const std::string& what);
  void update();

  /// Whether the goal may run; `result` says why not.
  bool mayBegin(const ExploreGoal& goal, ExploreResult& result) const;
  void begin(const ExploreGoal& goal);
  bool watch(std::chrono::nanoseconds now);
  /// Where the robot goes by odometry when nothing else tells where it is.
  std::optional<core::Pose2d> instead() const;
  void waitToBegin(const RobotFinder::Found& found);
  void drive(const core::Pose2d& spot, std::chrono::nanoseconds now);
  void take(const DriveReport& report);
  void sayFeedback(const DriveReport& report);
  void finishAsDecided();
  /// `message` by value: the run, which may hold it, ends here.
  void finish(std::uint8_t status, std::string message);

  const Context context_;
  const config::Parameters& parameters_;
  ActionThread<ExploreAction> thread_;
  std::unique_ptr<Pilot> pilot_;
  GoalHandle goal_;  // of run_
  std::optional<ExploreRun> run_;
  core::Pose2d driven_;                   // spot that the pilot drives to
  std::chrono::nanoseconds accepted_{0};  // when the goal was, steady
  GoalWatch watch_;
  ros::SteadyTime last_feedback_;
  DriveReport::State last_state_ = DriveReport::State::kGoing;  ///< what it does is said at once
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_EXPLORE_SERVER_H
