#ifndef PLACE_MEMORY_LAB_ROUTES_OFFICE_GOALS_H
#define PLACE_MEMORY_LAB_ROUTES_OFFICE_GOALS_H

#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/world/world.h"

namespace place_memory::routes {

/// What came of goals in a building whose ways close, also while the robot is on its way.
struct GoalCounts {
  int reached = 0;
  int no_route = 0;
  int stuck = 0;            ///< it got neither on nor back
  int others = 0;           ///< any other end
  int false_reached = 0;    ///< further than half a metre from where the robot truly was to be
  int false_no_route = 0;   ///< there was a way that nothing barred
  int false_blocked = 0;    ///< links taken for blocked that nothing barred
  int closed_ahead = 0;     ///< goals on the way to which something closed
  std::size_t blocked = 0;  ///< links found blocked
  std::size_t plans = 0;
  double longest_plan = 0.0;  ///< [s]
  double way = 0.0;           ///< driven [m]
  std::string messages;       ///< of `stuck` and `others`, a line each
};

/// Drives a simulated robot to random places of `world`, goal after goal: planner, links that
/// learn, the goal's run and the leg driver together, by what simulated sonars hear. Up to three
/// ways are barred before each goal, which the robot is not told, and up to two more once it is on
/// its way. For each goal the robot takes itself to be elsewhere than it is, by up to `astray` [m]
/// and a fifth of that in radians. Depends on the seed alone, but for times.
GoalCounts driveGoals(const sim::World& world, int goals, std::uint64_t seed, double astray);

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_LAB_ROUTES_OFFICE_GOALS_H
