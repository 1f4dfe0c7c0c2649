#include "core/drive/goal_run.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

// Further from the first place the robot goes there first [m].
constexpr double kAtPlace = 0.75;
constexpr int kMostElsewhere = 3;

Pose2d standAt(const Place& place) { return place.map_from_place * place.place_from_robot; }

double between(const Pose2d& one, const Pose2d& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

GoalRun::Outcome outcomeOf(RouteAnswer::Status status) {
  switch (status) {
    case RouteAnswer::Status::kUnknownGoal:
      return GoalRun::Outcome::kNotThere;
    case RouteAnswer::Status::kNotLocalized:
    case RouteAnswer::Status::kUnknownStart:
      return GoalRun::Outcome::kLost;
    default:
      return GoalRun::Outcome::kNoRoute;
  }
}

}  // namespace

GoalRun::GoalRun(Hooks hooks, std::optional<Pose2d> goal, std::string source)
    : hooks_(std::move(hooks)), goal_(goal), source_(std::move(source)) {}

void GoalRun::begin(const Pose2d& robot, std::chrono::nanoseconds now) {
  planFrom(kNoPlace, now);
  if (isOver() || !leg_) return;
  if (between(robot, leg_->target) > kAtPlace) return;
  leg_.reset();
  next(now);
}

void GoalRun::planFrom(PlaceId place, std::chrono::nanoseconds now) {
  const RoutePlan plan = hooks_.plan({place, avoided_, unreachable_});
  if (plan.answer.status != RouteAnswer::Status::kFound) {
    end(outcomeOf(plan.answer.status), plan.answer.reason);
  } else if (place == kNoPlace) {
    goToStart(plan, now);
  } else {
    plan_ = plan;
    at_ = 0;
    next(now);
  }
}

// Where the route is one place long this is the whole way.
void GoalRun::goToStart(RoutePlan plan, std::chrono::nanoseconds now) {
  plan_ = std::move(plan);
  at_ = 0;
  const Place& first = plan_.best.front();
  take({kNoPlace, first.id, first.label, standAt(first), false}, now);
}

void GoalRun::take(Leg leg, std::chrono::nanoseconds now) {
  leg_ = std::move(leg);
  leg_begun_ = now;
}

void GoalRun::next(std::chrono::nanoseconds now) {
  if (at_ + 1 < plan_.best.size()) {
    const Place& to = plan_.best[at_ + 1];
    take({plan_.best[at_].id, to.id, to.label, standAt(to), false}, now);
  } else if (goal_) {
    take({plan_.best[at_].id, kNoPlace, "the goal", *goal_, false}, now);
    goal_.reset();
  } else {
    end(Outcome::kReached, "reached \"" + plan_.best.back().label + "\"");
  }
}

void GoalRun::arrived(std::chrono::nanoseconds now) {
  if (isOver() || !leg_) return;
  const Leg done = *leg_;
  ++legs_done_;
  leg_.reset();
  unreachable_.clear();
  if (done.back) return planFrom(done.to, now);
  if (done.from != kNoPlace && done.to != kNoPlace) {
    hooks_.report({done.from, done.to, leg_begun_, now, true, source_});
    ++at_;
  }
  next(now);
}

void GoalRun::blocked(const std::string& why, std::chrono::nanoseconds now) {
  if (isOver() || !leg_) return;
  const Leg failed = *leg_;
  leg_.reset();
  failed_leg_ = inWords(failed) + ": " + why;
  tried_.push_back(failed_leg_);
  if (failed.to != kNoPlace && (failed.back || failed.from == kNoPlace)) {
    return beginElsewhere(failed, now);
  }
  if (failed.to == kNoPlace) return endBlocked();
  hooks_.report({failed.from, failed.to, leg_begun_, now, false, source_});
  avoided_.emplace_back(failed.from, failed.to);
  const Place& begin = plan_.best[at_];
  take({kNoPlace, begin.id, begin.label, standAt(begin), true}, now);
}

// What bars the way to that place says nothing of its links.
void GoalRun::beginElsewhere(const Leg& failed, std::chrono::nanoseconds now) {
  if (elsewhere_++ == kMostElsewhere) return endBlocked();
  unreachable_.push_back(failed.to);
  const RoutePlan plan = hooks_.plan({kNoPlace, avoided_, unreachable_});
  // There may well be a way, from the places that it does not get to.
  if (plan.answer.status != RouteAnswer::Status::kFound) return endBlocked();
  goToStart(plan, now);
}

void GoalRun::endBlocked() {
  end(Outcome::kBlocked, "the robot does not get on " + failed_leg_ +
                             ", and no other place is at hand: free the way, or drive it to a "
                             "place");
}

void GoalRun::placeRemoved(PlaceId id, std::chrono::nanoseconds now) {
  if (isOver() || plan_.best.empty()) return;
  if (plan_.best.back().id == id) {
    end(Outcome::kNotThere, "\"" + plan_.best.back().label + "\" was removed on the way there");
    return;
  }
  const auto route = plan_.best.begin() + static_cast<std::ptrdiff_t>(at_);
  const bool is_on_the_way =
      std::any_of(route, plan_.best.end(), [id](const Place& place) { return place.id == id; });
  if (is_on_the_way) planFrom(kNoPlace, now);
}

void GoalRun::follow(const std::function<std::optional<Place>(PlaceId)>& find,
                     std::chrono::nanoseconds now) {
  for (Place& place : plan_.best) {
    const std::optional<Place> now_so = find(place.id);
    if (!now_so) return placeRemoved(place.id, now);
    place = *now_so;
    if (!leg_ || leg_->to != place.id) continue;
    leg_->label = place.label;
    leg_->target = standAt(place);
  }
}

void GoalRun::end(Outcome outcome, const std::string& message) {
  if (isOver()) return;
  leg_.reset();
  outcome_ = outcome;
  message_ = message;
}

std::string GoalRun::labelOf(PlaceId id) const {
  for (const Place& place : plan_.best) {
    if (place.id == id) return "\"" + place.label + "\"";
  }
  return "where it stood";
}

std::string GoalRun::inWords(const Leg& leg) const {
  if (leg.back) return "back to \"" + leg.label + "\"";
  return "from " + labelOf(leg.from) + " to " +
         (leg.to == kNoPlace ? leg.label : "\"" + leg.label + "\"");
}

std::size_t GoalRun::legsLeft() const {
  if (isOver() || !leg_) return 0;
  const bool is_before_the_route = !leg_->back && leg_->from == kNoPlace && leg_->to != kNoPlace;
  const std::size_t after = leg_->back ? 0 : plan_.best.size() - 1 - at_;
  return std::max<std::size_t>(after + (is_before_the_route ? 1 : 0) + (goal_ ? 1 : 0), 1);
}

double GoalRun::timeLeft(double distance) const {
  if (isOver() || !leg_ || plan_.best.size() < 2) return 0.0;
  double whole = 0.0, left = distance;
  for (std::size_t i = 1; i < plan_.best.size(); ++i) {
    const double way = between(standAt(plan_.best[i - 1]), standAt(plan_.best[i]));
    whole += way;
    if (i > at_ + 1) left += way;
  }
  return whole > 0.0 ? plan_.answer.best.cost * left / whole : 0.0;
}

}  // namespace place_memory::core
