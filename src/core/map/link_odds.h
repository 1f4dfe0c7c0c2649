#ifndef PLACE_MEMORY_CORE_MAP_LINK_ODDS_H
#define PLACE_MEMORY_CORE_MAP_LINK_ODDS_H

#include <chrono>
#include <optional>

#include "place_memory/core/link_learning.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// What is left at `now` of the weight 1 that evidence had at `then`; 1 where `then` is later, as
/// after a clock was set back.
double weightLeft(std::chrono::nanoseconds then, std::chrono::nanoseconds now, double half_life);

/// How much traversals fail of what the priors expect, over a whole map.
class MapCaution {
 public:
  /// Counts what was learned of one direction, as it counts at `now`, for three traversals at most:
  /// one door that is always closed says little of others.
  void add(const LinkDirection& direction, std::chrono::nanoseconds now, double half_life);
  /// 1 where there is no evidence, towards 0 where nothing fails; at most 2.
  double value() const;

 private:
  double through_ = 0.0;
  double blocked_ = 0.0;
};

/// Chance of getting through in [kLeastOdds, 1): see LinkLearningOptions. `driven`: whether the
/// robot went along the link before, either way; `caution`: MapCaution's value.
double oddsThrough(const LinkDirection& direction, bool driven, double caution,
                   std::chrono::nanoseconds now, double half_life);
bool wasDriven(const PlaceLink& link);

/// Time that it takes to go along the link [s]: as it was timed, or by its length.
double expectedTime(const PlaceLink& link, const LinkDirection& direction,
                    const LinkLearningOptions& options);
/// Time that an attempt costs which fails [s]: as it was timed, or as long as to get through.
double expectedLoss(const LinkDirection& direction, double time);

/// What is known once the traversal counts. One that ends before the newest known counts as if it
/// ended then. `expected`: time that it was to take [s]; one that took more than ten times as long,
/// or no time, tells nothing of the time.
LinkDirection learned(LinkDirection direction, const Traversal& traversal, double expected,
                      double half_life);

/// So that the odds are kLeastOdds at `now`, and drift back.
LinkDirection blockedNow(LinkDirection direction, bool driven, std::chrono::nanoseconds now,
                         double half_life);
/// As if nothing had failed, and not forbidden.
LinkDirection unblocked(LinkDirection direction);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_LINK_ODDS_H
