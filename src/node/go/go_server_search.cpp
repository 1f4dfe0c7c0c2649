// A goal of a robot that does not know where it is, or does not know it any more.
#include <ros/console.h>

#include "node/go/go_server.h"
#include "node/names/node_names.h"

namespace place_memory::node {

using State = DriveReport::State;
using Outcome = core::GoalRun::Outcome;

void GoServer::beginSearch(const std::string& why) {
  if (!RobotSearch::isPossible(watch_.mode(), parameters_.drive.by)) {
    run_->end(Outcome::kLost, why);
    return;
  }
  ROS_INFO("%s: where on the map the robot is, is not known: it looks about", kGoToPlaceAction);
  if (!search_) search_.emplace(context_.pilot, context_.asker, *pilot_);
  search_->begin();
  searches_ = true;
}

void GoServer::search(std::chrono::nanoseconds now) {
  const DriveReport report = search_->update(now);
  if (!report.isOver()) {
    if (!isFeedbackDue(report.state)) return;
    GoToPlaceFeedback feedback;
    feedback.message = search_->inWords();
    if (report.state != State::kGoing) feedback.message += ": " + inWords(report);
    goal_.publishFeedback(feedback);
    return;
  }
  searches_ = false;
  if (report.state == State::kLost) {
    run_->end(Outcome::kLost, report.why);
    return finishIfOver();
  }
  if (report.state != State::kArrived) return take(report, now);
  // The route begins where the robot turned out to be.
  const RobotFinder::Found found = context_.pilot.finder.find(now);
  if (!found.fix) return beginSearch(found.problem);
  run_->begin(found.fix->map_from_base, now);
  finishIfOver();
}

}  // namespace place_memory::node
