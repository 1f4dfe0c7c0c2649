#include "node/go/robot_search.h"

#include <cstdio>
#include <vector>

#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

using State = DriveReport::State;
using core::Pose2d;

constexpr double kListen = 2.0;     // for a sonar that looks ahead [s]
constexpr double kTurnAndGo = 0.6;  // a view on the spot is looked at from so much nearer [m]

core::LostSearchOptions searchOptions(const config::DriveOptions& drive) {
  core::LostSearchOptions options;
  options.radius = drive.radius;
  options.clearance = drive.clearance;
  return options;
}

std::string inMetres(double way) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f m", way);
  return text;
}

}  // namespace

RobotSearch::RobotSearch(const Pilot::Context& context, const ViewAsker& asker, Pilot& pilot)
    : context_(context),
      asker_(asker),
      pilot_(pilot),
      search_(searchOptions(context.parameters.drive)) {
  context_.echoes.begin();
}

RobotSearch::~RobotSearch() { context_.echoes.end(); }

void RobotSearch::begin() {
  search_.pause();
  search_.arrived();
  begun_ = steadyNow();
}

std::string RobotSearch::inWords() const {
  return "looks about to find out where it is: drives to where " +
         (search_.isAdvised()
              ? "a view parts the " + std::to_string(candidates_) + " spots where it may be"
              : std::string("there is room"));
}

DriveReport RobotSearch::end(State state, const std::string& why) {
  pilot_.stop();
  return {state, why, 0.0};
}

DriveReport RobotSearch::update(std::chrono::nanoseconds now) {
  const RobotFinder::Found known = context_.finder.find(now);
  if (known.fix) return end(State::kArrived, "");
  const RobotFinder::Found by_odometry = context_.finder.find(now, Pose2d{});
  if (by_odometry.fix) search_.follow(by_odometry.fix->odom_from_base, now);
  const std::string in_vain =
      known.problem + "; driving " + inMetres(search_.way()) + " about did not tell";
  if (search_.isOver()) return end(State::kLost, in_vain);
  if (!search_.target()) {
    if (!by_odometry.fix) return end(State::kAdrift, by_odometry.problem);
    if (context_.echoes.ring().isBlind(now)) {
      if (toSeconds(steadyNow() - begun_) < kListen) return {State::kWaiting, "", 0.0};
      return end(State::kSilent, "no sonar that looks ahead is heard");
    }
    if (!decide(now)) return end(State::kLost, in_vain + ", and there is no way on");
  }
  const DriveReport report = pilot_.update(now, Pose2d{});
  if (!report.isOver()) return report;
  if (report.state == State::kArrived || report.state == State::kBlocked) {
    if (report.state == State::kArrived) search_.arrived();
    if (report.state == State::kBlocked) search_.blocked();
    return {State::kGoing, "", 0.0};
  }
  return report;
}

bool RobotSearch::decide(std::chrono::nanoseconds now) {
  const ViewAsker::Asked asked = asker_.ask();
  candidates_ = asked.advice.candidates.size();
  std::vector<Pose2d> spots;
  if (const auto& view = asked.advice.view) {
    for (const Pose2d& spot : view->spots) spots.push_back(asked.odom_from_base * spot);
    if (spots.empty()) {
      spots.push_back(asked.odom_from_base * Pose2d{0.0, 0.0, view->bearing} *
                      Pose2d{kTurnAndGo, 0.0, 0.0});
    }
  }
  search_.decide(spots, context_.echoes.ring(), now);
  if (!search_.target()) return false;
  pilot_.driveTo(*search_.target());
  return true;
}

}  // namespace place_memory::node
