#include "node/go/view_asker.h"

#include "core/memory/memory_views.h"
#include "node/base/ros_time.h"
#include "node/input/sensor_placement.h"

namespace place_memory::node {
namespace {

using core::Pose2d;

constexpr double kNever = 2.0;  // a probability that none has

}  // namespace

ViewAsker::Known ViewAsker::byBelief() const {
  Known known;
  const std::optional<core::BeliefSummary> belief = context_.driver.belief();
  if (!belief) return known;
  known.odom_from_base = belief->odom_from_base;
  if (belief->seen) known.question.seen = core::SeenGrid{*belief->seen, belief->seen_from_base};
  for (const core::BelievedPlace& place : belief->places) {
    known.question.candidates.push_back({place.id, place.map_from_base, place.probability});
  }
  return known;
}

ViewAsker::Known ViewAsker::byAnswer() const {
  Known known;
  const std::shared_ptr<const ScanAnswer> answer = context_.newest_answer();
  if (!answer) return known;
  known.odom_from_base = answer->odom_from_scan * answer->robot_in_scan;
  known.question.seen = core::SeenGrid{answer->grid, answer->robot_in_scan};
  for (const core::PlaceMatch& match : answer->matches) {
    const std::optional<core::Place> place = context_.memory.place(match.id);
    if (!place) continue;
    known.question.candidates.push_back(
        {match.id, place->map_from_place * match.place_from_scan * answer->robot_in_scan,
         match.probability, place->session});
  }
  return known;
}

bool ViewAsker::isSure() const {
  if (context_.driver.mode() != config::Mode::kOff) {
    return context_.finder.find(rosNow()).fix.has_value();
  }
  const std::shared_ptr<const ScanAnswer> answer = context_.newest_answer();
  return answer && answer->verdict == core::Verdict::kRecognized;
}

ViewAsker::Asked ViewAsker::ask() const {
  Asked asked;
  if (isSure()) {
    asked.advice.status = core::ViewAdvice::Status::kSure;
    return asked;
  }
  Known known = context_.driver.mode() == config::Mode::kOff ? byAnswer() : byBelief();
  asked.odom_from_base = known.odom_from_base;
  std::chrono::nanoseconds stamp{0};
  const config::Parameters& parameters = context_.parameters;
  if (!parameters.odom_frame.empty()) {
    const auto base =
        lookupNewest(context_.buffer, parameters.odom_frame, parameters.base_frame, stamp);
    if (base) asked.odom_from_base = base->pose;
  }
  const Pose2d moved = known.odom_from_base.inverse() * asked.odom_from_base;
  for (core::PoseCandidate& candidate : known.question.candidates) {
    candidate.map_from_base = candidate.map_from_base * moved;
  }
  if (known.question.seen) {
    known.question.seen->grid_from_base = known.question.seen->grid_from_base * moved;
  }
  known.question.turn_rate = parameters.drive.turn_rate;
  known.question.sure = kNever;  // who says that it is sure where the robot is says so above
  asked.advice = core::adviseView(context_.memory, parameters.routes, rosNow(), known.question);
  return asked;
}

}  // namespace place_memory::node
