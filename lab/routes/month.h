#ifndef PLACE_MEMORY_LAB_ROUTES_MONTH_H
#define PLACE_MEMORY_LAB_ROUTES_MONTH_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "place_memory/core/link_learning.h"
#include "routes/door_world.h"
#include "routes/route_minds.h"

namespace place_memory::routes {

struct Errand {
  std::size_t from = 0;
  std::size_t to = 0;
  double begin = 0.0;  ///< [s]
};

/// What came of an errand.
struct Errands {
  double time = 0.0;  ///< of all that were driven [s]
  std::size_t reached = 0;
  std::size_t not_reached = 0;  ///< no way was left: the robot is carried, which takes ten minutes
  std::size_t blocked = 0;      ///< attempts at links that failed
};

/// Drives as the mind says until the goal is reached; what is found blocked is left out from there
/// on. Adds to `sum`. `passed`, where given, is told of each passage that was gone through, and
/// when.
void drive(const DoorWorld& world, const Errand& errand, RouteMind& mind, Errands& sum,
           const std::function<void(std::size_t, double)>& passed = nullptr);

/// The errands of a day, 40, at random from place to place.
std::vector<Errand> errandsOf(const DoorWorld& world, std::uint64_t seed, int day);

/// Thirty days, all minds at the same errands.
struct MonthResult {
  double learned_after = 0.0;  ///< days until links were travelled 20 times on average
  // From there on:
  Errands learning;
  Errands odds;   ///< an oracle that knows the odds
  Errands doors;  ///< one that sees every door
  Errands times;  ///< one that knows how long links take, and of no door
};
MonthResult runMonth(std::uint64_t seed, const core::LinkLearningOptions& options);

/// Days until a door, which was closed for ten days, is used again once it is open; nothing: never
/// in ten days.
std::optional<double> daysToReturn(std::uint64_t seed, const core::LinkLearningOptions& options);

/// Where nothing closes, by how much the worst and the mean way were longer than the shortest,
/// after 20 traversals a link.
struct Detours {
  double worst = 0.0;
  double mean = 0.0;
};
Detours detours(std::uint64_t seed, const core::LinkLearningOptions& options);

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_LAB_ROUTES_MONTH_H
