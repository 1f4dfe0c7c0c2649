#include "node/go/explore_server.h"

#include <ros/console.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "node/base/ros_time.h"
#include "node/drive/drive_publisher.h"
#include "node/go/go_goal.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

using Result = ExploreResult;
using State = DriveReport::State;
using Explorer = core::Explorer;

const ros::WallDuration kUpdatePeriod(0.05);
const ros::WallDuration kFeedbackPeriod(0.2);
const ros::WallDuration kLastMessages(0.1);  // need so long to get out of the process
constexpr char kWho[] = "a goal of ~explore";
constexpr char kSource[] = "explore";
constexpr double kSameSpot = 0.15;       // [m]
constexpr double kBeginPatience = 10.0;  // with readings and odometry that do not come [s]

std::string aimInWords(Explorer::Aim aim) {
  switch (aim) {
    case Explorer::Aim::kLoop:
      return "drives back to where it was sure where it is";
    case Explorer::Aim::kHome:
      return "drives home";
    case Explorer::Aim::kFrontier:
      break;
  }
  return "drives to where free space opens";
}

geometry_msgs::Point toPoint(const core::Pose2d& spot) {
  geometry_msgs::Point point;
  point.x = spot.x;
  point.y = spot.y;
  return point;
}

std::string inMetres(double way) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f m", way);
  return text;
}

/// What came of it, for the end of a sentence.
std::string sumUp(const ExploreRun& run) {
  return std::to_string(run.places()) + (run.places() == 1 ? " place" : " places") + " made on " +
         inMetres(run.way()) +
         (run.isHome() ? ", and the robot is home" : ", and the robot is not at home");
}

}  // namespace

ExploreServer::ExploreServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                             const Context& context)
    : context_(context),
      parameters_(context.pilot.parameters),
      thread_(names, private_names, kExploreAction, kUpdatePeriod,
              {[this](const GoalHandle& goal) { onGoal(goal); },
               [this](const GoalHandle& goal) { onCancel(goal); }, [this] { update(); },
               [this](const std::string& what) { onError(what); }}),
      pilot_(std::make_unique<Pilot>(thread_.names(), context.pilot)),
      watch_(toNanoseconds(parameters_.time_jump_tolerance)) {
  thread_.start();
}

ExploreServer::~ExploreServer() { stop(); }

void ExploreServer::stop() {
  if (!thread_.halt()) return;
  if (run_) {
    finish(Result::SHUTDOWN, "the node was stopped, and the robot with it");
    kLastMessages.sleep();
  }
  goal_ = GoalHandle();
  pilot_.reset();
  thread_.close();
}

bool ExploreServer::mayBegin(const ExploreGoal& goal, ExploreResult& result) const {
  const config::Mode mode = context_.driver.mode();
  if (!ros::Time::isValid()) {
    result.status = Result::NO_TIME;
    result.message = "use_sim_time is set, but no time has come on /clock yet";
  } else if (isTaken(goal, result) && mode != config::Mode::kMap) {
    result.status = Result::WRONG_MODE;
    result.message = std::string("the mode is ") + nameOf(mode) +
                     ", and exploring makes a map: call ~set_mode with map first";
  }
  return result.message.empty();
}

void ExploreServer::onGoal(const GoalHandle& goal) {
  GoalHandle accepted = goal;
  Result result;
  bool may_begin = mayBegin(*accepted.getGoal(), result);
  if (may_begin && run_) finish(Result::PREEMPTED, "a newer goal came");
  if (may_begin && !pilot_->take(kWho, result.message)) {
    result.status = Result::BUSY;
    may_begin = false;
  }
  if (!may_begin) {
    accepted.setRejected(result, result.message);
    return;
  }
  goal_ = accepted;
  goal_.setAccepted();
  begin(*goal_.getGoal());
}

void ExploreServer::begin(const ExploreGoal& goal) {
  watch_.begin(rosNow(), context_.driver.mode());
  accepted_ = steadyNow();
  run_.emplace(ExploreRun::Context{context_.memory, context_.feed, parameters_}, goal.most_distance,
               goal.stay);
}

void ExploreServer::onCancel(const GoalHandle& goal) {
  if (run_ && goal == goal_) finish(Result::CANCELED, "it was canceled; the robot stands");
}

void ExploreServer::onError(const std::string& what) {
  if (run_) finish(Result::FAILED, "an error in the node: " + what + "; send the goal again");
}

bool ExploreServer::watch(std::chrono::nanoseconds now) {
  const auto end = watch_.update(now, context_.driver.mode());
  if (!end) return false;
  switch (end->kind) {
    case GoalWatch::Kind::kTimeJumped:
      finish(Result::LOST, end->why);
      break;
    case GoalWatch::Kind::kTimeStands:
      finish(Result::NO_TIME, end->why);
      break;
    case GoalWatch::Kind::kModeChanged:
      finish(Result::WRONG_MODE,
             "the mode was set to another one on the way, and exploring makes "
             "a map: set it to map and send the goal again");
      break;
  }
  return true;
}

// A server that drives by the map needs to be told where the robot is on it.
std::optional<core::Pose2d> ExploreServer::instead() const {
  if (parameters_.drive.by == config::DriveBy::kMoveBase) return std::nullopt;
  return run_->mapFromOdom();
}

void ExploreServer::update() {
  if (!run_) return;
  const std::chrono::nanoseconds now = rosNow();
  if (watch(now)) return;
  const RobotFinder::Found found = context_.pilot.finder.find(now, instead());
  if (found.fix) run_->follow(*found.fix);
  if (run_->hasJumped()) {
    return finish(
        Result::LOST,
        "odometry jumped: the robot was carried, or its odometry was reset; send the goal "
        "again, and it explores from where it is");
  }
  if (run_->isOver()) return finishAsDecided();
  if (run_->isLost()) {
    return finish(Result::LOST,
                  "where the robot is has not been known for too long a way: drive it "
                  "to where the map knows it, or say where it is on initialpose, and "
                  "send the goal again");
  }
  if (const auto spot = run_->spot()) return drive(*spot, now);
  waitToBegin(found);
}

void ExploreServer::waitToBegin(const RobotFinder::Found& found) {
  if (run_->hasBegun() || toSeconds(steadyNow() - accepted_) < kBeginPatience) return;
  if (!found.fix) return finish(Result::LOST, found.problem);
  finish(Result::SILENT,
         "no reading of a sonar comes that could be put on the map: do the topics of "
         "sonar_topics publish, and do /diagnostics say what is wrong?");
}

void ExploreServer::drive(const core::Pose2d& spot, std::chrono::nanoseconds now) {
  const bool is_same = std::hypot(spot.x - driven_.x, spot.y - driven_.y) <= kSameSpot;
  if (!pilot_->isDriving() || !is_same) {
    pilot_->driveTo(spot);
  } else if (!(spot == driven_)) {
    pilot_->moveTarget(spot);
  }
  driven_ = spot;
  const DriveReport report = pilot_->update(now, instead());
  if (report.isOver()) {
    take(report);
  } else {
    sayFeedback(report);
  }
}

void ExploreServer::take(const DriveReport& report) {
  switch (report.state) {
    case State::kArrived:
      return run_->arrived();
    case State::kBlocked:
      ROS_INFO("%s: %s", kSource, report.why.c_str());
      return run_->blocked(report.why);
    case State::kSilent:
      return finish(Result::SILENT, report.why);
    case State::kPreempted:
      return finish(Result::PREEMPTED, report.why);
    default:
      return finish(Result::LOST, report.why);
  }
}

void ExploreServer::sayFeedback(const DriveReport& report) {
  const ros::SteadyTime steady = ros::SteadyTime::now();
  if (report.state == last_state_ && steady - last_feedback_ < kFeedbackPeriod) return;
  last_feedback_ = steady;
  last_state_ = report.state;
  ExploreFeedback feedback;
  feedback.message = aimInWords(run_->task()->aim);
  if (report.state != State::kGoing) feedback.message += ": " + inWords(report);
  feedback.target = toPoint(run_->task()->target);
  feedback.places = static_cast<std::uint32_t>(run_->places());
  feedback.distance = run_->way();
  feedback.frontiers = static_cast<std::uint32_t>(run_->frontiers());
  goal_.publishFeedback(feedback);
}

void ExploreServer::finishAsDecided() {
  const std::string sum = sumUp(*run_);
  const std::size_t left = run_->left().size();
  switch (run_->outcome()) {
    case Explorer::Outcome::kDone:
      return finish(Result::DONE,
                    (left > 0 ? "nothing is left but what it could not reach or gave up, see left: "
                              : "nothing is left that the robot can reach: ") +
                        sum);
    case Explorer::Outcome::kBoundReached:
      return finish(Result::BOUND_REACHED,
                    "most_distance is driven: " + sum + "; send the goal again to go on");
    case Explorer::Outcome::kBlocked:
      return finish(Result::BLOCKED, "the robot gets neither on nor back: " + sum +
                                         "; free its way, and send the goal again");
    case Explorer::Outcome::kUnderWay:
      break;
  }
  finish(Result::FAILED, "an exploration ended without a reason; send the goal again");
}

void ExploreServer::finish(std::uint8_t status, std::string message) {
  pilot_->give();
  Result result;
  result.status = status;
  result.message = std::move(message);
  result.home = run_->isHome();
  result.places = static_cast<std::uint32_t>(run_->places());
  result.distance = run_->way();
  for (const Explorer::Left& left : run_->left()) {
    result.left.push_back(toPoint(left.spot));
    result.why.push_back(left.why);
  }
  run_.reset();
  ROS_INFO("%s: %s", kSource, result.message.c_str());
  if (status == Result::DONE || status == Result::BOUND_REACHED) {
    goal_.setSucceeded(result, result.message);
  } else if (status == Result::CANCELED || status == Result::PREEMPTED) {
    goal_.setCanceled(result, result.message);
  } else {
    goal_.setAborted(result, result.message);
  }
}

}  // namespace place_memory::node
