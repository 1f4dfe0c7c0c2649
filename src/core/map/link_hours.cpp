#include "core/map/link_hours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/map/link_odds.h"
#include "place_memory/core/link_learning.h"

namespace place_memory::core {
namespace {

constexpr double kHour = 3600.0;  // [s]
constexpr int kHours = 24;

// Rhythms outlive what is barred for a while.
constexpr double kHalfLife = 14.0 * kHours * kHour;  // [s]

// How much the hours beside one say of it.
constexpr std::array<double, 3> kBeside = {1.0, 0.5, 0.1};
// Traversals for which it counts that an hour is as all are.
constexpr double kPrior = 1.0;

// Of the gain of older traversals so much is left at each new one.
constexpr double kKept = 0.98;
constexpr double kLeastGain = -2.0;
constexpr double kMostGain = 8.0;
constexpr double kUsedFrom = 3.0;  // 20 to 1

constexpr double kMostShift = 4.0;
constexpr double kSaidClosed = 2.0 * kLeastOdds;

double logit(double odds) { return std::log(odds / (1.0 - odds)); }

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

double share(double through, double blocked) { return (through + 1.0) / (through + blocked + 2.0); }

double logLikelihood(double odds, bool succeeded) {
  return std::log(succeeded ? odds : 1.0 - odds);
}

double shifted(double odds, double shift) {
  return std::clamp(logistic(logit(odds) + shift), kLeastOdds, 1.0 - kLeastOdds);
}

}  // namespace

int LinkHours::hourOf(std::chrono::nanoseconds time) {
  const std::int64_t hour = std::chrono::duration_cast<std::chrono::hours>(time).count() % kHours;
  return static_cast<int>(hour < 0 ? hour + kHours : hour);
}

void LinkHours::age(Count& count, double left) {
  count.through *= left;
  count.blocked *= left;
}

double LinkHours::shift(const Hours& hours, int hour) {
  Count all, here;
  for (int at = 0; at < kHours; ++at) {
    const Count& count = hours.at[static_cast<std::size_t>(at)];
    all.through += count.through;
    all.blocked += count.blocked;
    const int apart = std::abs(at - hour);
    const auto away = static_cast<std::size_t>(std::min(apart, kHours - apart));
    if (away >= kBeside.size()) continue;
    here.through += kBeside[away] * count.through;
    here.blocked += kBeside[away] * count.blocked;
  }
  const double mean = share(all.through, all.blocked);
  const double then = (here.through + kPrior * mean) / (here.through + here.blocked + kPrior);
  const double bounded = std::clamp(then, kLeastOdds, 1.0 - kLeastOdds);
  return std::clamp(logit(bounded) - logit(mean), -kMostShift, kMostShift);
}

void LinkHours::note(const Traversal& traversal) {
  const auto ends = std::minmax(traversal.from, traversal.to);
  auto known = links_.find(ends);
  if (known == links_.end()) {
    if (traversal.succeeded) return;
    known = links_.emplace(ends, Hours()).first;
    known->second.last = traversal.end;
  }
  Hours& hours = known->second;
  const std::chrono::nanoseconds now = std::max(traversal.end, hours.last);
  for (Count& count : hours.at) age(count, weightLeft(hours.last, now, kHalfLife));
  age(hours.lately, weightLeft(hours.last, now, half_life_));
  hours.last = now;
  const int hour = hourOf(now);
  const double plain = share(hours.lately.through, hours.lately.blocked);
  const double gained =
      logLikelihood(shifted(plain, shift(hours, hour)), traversal.succeeded) -
      logLikelihood(std::clamp(plain, kLeastOdds, 1.0 - kLeastOdds), traversal.succeeded);
  hours.gain = std::clamp(kKept * hours.gain + gained, kLeastGain, kMostGain);
  for (Count* count : {&hours.at[static_cast<std::size_t>(hour)], &hours.lately}) {
    (traversal.succeeded ? count->through : count->blocked) += 1.0;
  }
}

void LinkHours::forget(PlaceId one, PlaceId other) { links_.erase(std::minmax(one, other)); }

double LinkHours::weighed(const PlaceLink& link, double odds, std::chrono::nanoseconds now) const {
  const auto known = links_.find({link.first, link.second});
  if (known == links_.end() || known->second.gain < kUsedFrom) return odds;
  const double by_hour = shift(known->second, hourOf(now));
  if (odds < kSaidClosed && by_hour > 0.0) return odds;
  return shifted(odds, by_hour);
}

bool LinkHours::any() const {
  return std::any_of(links_.begin(), links_.end(),
                     [](const auto& link) { return link.second.gain >= kUsedFrom; });
}

}  // namespace place_memory::core
