#include "node/go/go_server.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "node/base/ros_time.h"
#include "node/go/go_goal.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

using Result = GoToPlaceResult;
using State = DriveReport::State;
using Outcome = core::GoalRun::Outcome;

const ros::WallDuration kUpdatePeriod(0.05);
const ros::WallDuration kFeedbackPeriod(0.2);
const ros::WallDuration kLastMessages(0.1);  // need so long to get out of the process
constexpr char kWho[] = "a goal of ~go_to_place";
constexpr char kSource[] = "go_to_place";  // of traversals

std::uint8_t statusOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kReached:
      return Result::REACHED;
    case Outcome::kNoRoute:
      return Result::NO_ROUTE;
    case Outcome::kNotThere:
      return Result::UNKNOWN_GOAL;
    case Outcome::kLost:
      return Result::LOST;
    case Outcome::kBlocked:
      return Result::BLOCKED;
    case Outcome::kSilent:
      return Result::SILENT;
    case Outcome::kPreempted:
      return Result::PREEMPTED;
    case Outcome::kCanceled:
      return Result::CANCELED;
    case Outcome::kUnderWay:
    case Outcome::kFailed:
      break;
  }
  return Result::FAILED;
}

}  // namespace

GoServer::GoServer(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                   const Context& context)
    : context_(context),
      parameters_(context.pilot.parameters),
      thread_(names, private_names, kGoToPlaceAction, kUpdatePeriod,
              {[this](const GoalHandle& goal) { onGoal(goal); },
               [this](const GoalHandle& goal) { onCancel(goal); }, [this] { update(); },
               [this](const std::string& what) { onError(what); }}),
      pilot_(std::make_unique<Pilot>(thread_.names(), context.pilot)),
      watch_(toNanoseconds(parameters_.time_jump_tolerance)) {
  thread_.start();
}

GoServer::~GoServer() { stop(); }

void GoServer::stop() {
  if (!thread_.halt()) return;
  if (run_) {
    finish(Result::SHUTDOWN, "the node was stopped, and the robot with it");
    kLastMessages.sleep();
  }
  goal_ = GoalHandle();
  pilot_.reset();
  thread_.close();
}

void GoServer::onGoal(const GoalHandle& goal) {
  GoalHandle accepted = goal;
  Result result;
  std::optional<core::RouteEnd> end;
  if (ros::Time::isValid()) {
    end = readGoal(*accepted.getGoal(), context_.memory, parameters_.map_frame, result);
  } else {
    result.status = Result::NO_TIME;
    result.message = "use_sim_time is set, but no time has come on /clock yet";
  }
  if (end && !pilot_->take(kWho, result.message)) {
    result.status = Result::BUSY;
    end.reset();
  }
  if (!end) {
    accepted.setRejected(result, result.message);
    return;
  }
  if (run_) {
    finish(Result::PREEMPTED, "a newer goal came");
    if (!pilot_->take(kWho, result.message)) {
      result.status = Result::BUSY;
      accepted.setRejected(result, result.message);
      return;
    }
  }
  goal_ = accepted;
  goal_.setAccepted();
  begin(*end);
}

void GoServer::begin(const core::RouteEnd& end) {
  const std::chrono::nanoseconds now = rosNow();
  watch_.begin(now, context_.driver.mode());
  map_version_ = context_.memory.version();
  end_ = end;
  core::GoalRun::Hooks hooks;
  hooks.plan = [this](const core::GoalRun::Wish& wish) { return plan(wish); };
  hooks.report = [this](const core::Traversal& traversal) { report(traversal); };
  run_.emplace(hooks, end.pose, kSource);
  const RobotFinder::Found found = context_.pilot.finder.find(now);
  if (found.fix) {
    run_->begin(found.fix->map_from_base, now);
  } else if (found.odometry_is_old) {
    run_->end(Outcome::kLost, found.problem);
  } else {
    beginSearch(found.problem);
  }
  finishIfOver();
}

core::RoutePlan GoServer::plan(const core::GoalRun::Wish& wish) const {
  core::RouteQuery query;
  query.goal = end_;
  query.avoided = wish.avoided;
  query.second = false;
  if (wish.from != core::kNoPlace) {
    query.start = core::RouteEnd{wish.from, "", std::nullopt};
  } else if (const auto found = context_.pilot.finder.find(rosNow()); found.fix) {
    query.starts = context_.pilot.finder.starts(*found.fix, wish.unreachable);
  }
  return context_.memory.plan(query);
}

// Ways that are driven while the node drives along teach their links by themselves.
void GoServer::report(const core::Traversal& traversal) {
  if (traversal.succeeded && watch_.mode() != config::Mode::kOff) return;
  try {
    context_.memory.reportTraversal(traversal);
  } catch (const core::PlaceMemoryError& error) {
    ROS_WARN("%s: a link does not learn: %s", kSource, error.what());
  }
}

void GoServer::onCancel(const GoalHandle& goal) {
  if (run_ && goal == goal_) finish(Result::CANCELED, "it was canceled; the robot stands");
}

void GoServer::onError(const std::string& what) {
  if (run_) finish(Result::FAILED, "an error in the node: " + what + "; send the goal again");
}

bool GoServer::watch(std::chrono::nanoseconds now) {
  if (const auto end = watch_.update(now, context_.driver.mode())) {
    const bool stands = end->kind == GoalWatch::Kind::kTimeStands;
    finish(stands ? Result::NO_TIME : Result::LOST, end->why);
    return true;
  }
  if (const std::uint64_t version = context_.memory.version(); version != map_version_) {
    map_version_ = version;
    run_->follow([this](core::PlaceId id) { return context_.memory.place(id); }, now);
  }
  finishIfOver();
  return !run_;
}

void GoServer::update() {
  if (!run_) return;
  const std::chrono::nanoseconds now = rosNow();
  if (watch(now)) return;
  if (searches_) {
    search(now);
  } else {
    drive(now);
  }
}

void GoServer::drive(std::chrono::nanoseconds now) {
  const core::GoalRun::Leg& leg = *run_->leg();
  if (!pilot_->isDriving() || leg.from != driven_.from || leg.to != driven_.to) {
    pilot_->driveTo(leg.target);
  } else if (!(leg.target == driven_.target)) {
    pilot_->moveTarget(leg.target);
  }
  driven_ = leg;
  const DriveReport report = pilot_->update(now);
  if (report.isOver()) {
    take(report, now);
  } else {
    sayFeedback(report);
  }
}

void GoServer::take(const DriveReport& report, std::chrono::nanoseconds now) {
  switch (report.state) {
    case State::kArrived:
      run_->arrived(now);
      break;
    case State::kBlocked:
      run_->blocked(report.why, now);
      ROS_INFO("%s: %s", kSource, run_->failedLeg().c_str());
      break;
    case State::kSilent:
      run_->end(Outcome::kSilent, report.why);
      break;
    case State::kPreempted:
      run_->end(Outcome::kPreempted, report.why);
      break;
    case State::kLost:
      beginSearch(report.why);
      break;
    default:
      run_->end(Outcome::kLost, report.why);
      break;
  }
  finishIfOver();
}

bool GoServer::isFeedbackDue(State state) {
  const ros::SteadyTime steady = ros::SteadyTime::now();
  if (state == last_state_ && steady - last_feedback_ < kFeedbackPeriod) return false;
  last_feedback_ = steady;
  last_state_ = state;
  return true;
}

void GoServer::sayFeedback(const DriveReport& report) {
  if (!isFeedbackDue(report.state)) return;
  const core::GoalRun::Leg& leg = *run_->leg();
  GoToPlaceFeedback feedback;
  feedback.leg = run_->legInWords();
  feedback.next_id = leg.to;
  feedback.next_label = leg.to == core::kNoPlace ? "" : leg.label;
  feedback.distance = report.distance;
  feedback.legs_left = static_cast<std::uint32_t>(run_->legsLeft());
  feedback.time_left = run_->timeLeft(report.distance);
  feedback.message = inWords(report);
  goal_.publishFeedback(feedback);
}

void GoServer::finishIfOver() {
  if (run_ && run_->isOver()) finish(statusOf(run_->outcome()), run_->message());
}

void GoServer::finish(std::uint8_t status, std::string message) {
  pilot_->give();
  Result result;
  result.status = status;
  result.message = std::move(message);
  result.failed_leg = run_->failedLeg();
  result.tried = run_->tried();
  result.legs = static_cast<std::uint32_t>(run_->legsDone());
  run_.reset();
  search_.reset();
  searches_ = false;
  ROS_INFO("%s: %s", kSource, result.message.c_str());
  if (status == Result::REACHED) {
    goal_.setSucceeded(result, result.message);
  } else if (status == Result::CANCELED || status == Result::PREEMPTED) {
    goal_.setCanceled(result, result.message);
  } else {
    goal_.setAborted(result, result.message);
  }
}

}  // namespace place_memory::node
