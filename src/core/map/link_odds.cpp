#include "core/map/link_odds.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

// The priors (a, b) of links that were driven and of those that were not.
constexpr double kDrivenThrough = 4.0;
constexpr double kInferredThrough = 2.0;
constexpr double kPriorBlocked = 1.0;
// Share of traversals that the prior of a driven link expects to fail.
constexpr double kPriorFailures = kPriorBlocked / (kDrivenThrough + kPriorBlocked);
constexpr double kMostCaution = 2.0;
constexpr double kMostOfOneDirection = 3.0;  // traversals

// The newest traversal counts for so much of a mean at least, that it follows what changes.
constexpr double kNewestShare = 0.1;
// Who takes so many times longer did not only drive.
constexpr double kTooLong = 10.0;
// A link between places that lie in one another still takes a moment.
constexpr double kLeastTime = 1.0;  // [s]

/// Of any two times: what a store or a client says may lie further apart than nanoseconds count.
double secondsBetween(std::chrono::nanoseconds begin, std::chrono::nanoseconds end) {
  using Seconds = std::chrono::duration<double>;
  return (Seconds(end) - Seconds(begin)).count();
}

void age(LinkDirection& direction, std::chrono::nanoseconds now, double half_life) {
  const double left = weightLeft(direction.last, now, half_life);
  direction.through *= left;
  direction.blocked *= left;
  direction.last = std::max(direction.last, now);
}

double priorThrough(bool driven) { return driven ? kDrivenThrough : kInferredThrough; }

}  // namespace

double weightLeft(std::chrono::nanoseconds then, std::chrono::nanoseconds now, double half_life) {
  return now <= then ? 1.0 : std::exp2(-secondsBetween(then, now) / half_life);
}

void MapCaution::add(const LinkDirection& direction, std::chrono::nanoseconds now,
                     double half_life) {
  double left = weightLeft(direction.last, now, half_life);
  const double all = left * (direction.through + direction.blocked);
  if (all > kMostOfOneDirection) left *= kMostOfOneDirection / all;
  through_ += left * direction.through;
  blocked_ += left * direction.blocked;
}

double MapCaution::value() const {
  return std::min((1.0 + blocked_) / (1.0 + kPriorFailures * (through_ + blocked_)), kMostCaution);
}

double oddsThrough(const LinkDirection& direction, bool driven, double caution,
                   std::chrono::nanoseconds now, double half_life) {
  const double left = weightLeft(direction.last, now, half_life);
  const double through = priorThrough(driven) + left * direction.through;
  const double blocked = kPriorBlocked * caution + left * direction.blocked;
  return std::max(through / (through + blocked), kLeastOdds);
}

bool wasDriven(const PlaceLink& link) {
  return link.forward.succeeded > 0 || link.backward.succeeded > 0;
}

double expectedTime(const PlaceLink& link, const LinkDirection& direction,
                    const LinkLearningOptions& options) {
  if (direction.time > 0.0) return direction.time;
  const LinkDirection& other = &direction == &link.forward ? link.backward : link.forward;
  if (other.time > 0.0) return other.time;
  const double way = std::hypot(link.first_from_second.x, link.first_from_second.y);
  return std::max(way / options.speed, kLeastTime);
}

double expectedLoss(const LinkDirection& direction, double time) {
  return direction.lost_time > 0.0 ? direction.lost_time : time;
}

LinkDirection learned(LinkDirection direction, const Traversal& traversal, double expected,
                      double half_life) {
  age(direction, traversal.end, half_life);
  const double took = secondsBetween(traversal.begin, traversal.end);
  const bool is_timed = took > 0.0 && took <= kTooLong * expected;
  std::uint32_t& count = traversal.succeeded ? direction.succeeded : direction.failed;
  if (count < UINT32_MAX) ++count;
  const double share = std::max(1.0 / count, kNewestShare);
  if (traversal.succeeded) {
    direction.through += 1.0;
    if (is_timed && direction.time > 0.0) {
      const double off = took - direction.time;
      direction.time += share * off;
      direction.time_sigma = std::sqrt(
          (1.0 - share) * (direction.time_sigma * direction.time_sigma + share * off * off));
    } else if (is_timed) {
      direction.time = took;
    }
  } else {
    direction.blocked += 1.0;
    if (is_timed) {
      direction.lost_time = direction.lost_time > 0.0
                                ? direction.lost_time + share * (took - direction.lost_time)
                                : took;
    }
  }
  return direction;
}

LinkDirection blockedNow(LinkDirection direction, bool driven, std::chrono::nanoseconds now,
                         double half_life) {
  age(direction, now, half_life);
  const double through = priorThrough(driven) + direction.through;
  direction.blocked = std::max(direction.blocked, through * (1.0 / kLeastOdds - 1.0));
  return direction;
}

LinkDirection unblocked(LinkDirection direction) {
  direction.blocked = 0.0;
  direction.forbidden = false;
  return direction;
}

}  // namespace place_memory::core
