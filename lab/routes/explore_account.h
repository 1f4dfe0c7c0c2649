#ifndef PLACE_MEMORY_ROUTES_EXPLORE_ACCOUNT_H
#define PLACE_MEMORY_ROUTES_EXPLORE_ACCOUNT_H

#include <cstddef>
#include <vector>

#include "core/explore/explorer.h"

namespace place_memory::routes {

/// Where the metres of an exploration go: all that is driven on a task is in one of the first four.
struct ExploreAccount {
  double fruitful = 0.0;   ///< towards frontiers, where it showed new floor on that task [m]
  double fruitless = 0.0;  ///< towards frontiers, where it did not [m]
  double loops = 0.0;      ///< back to where it was sure of itself [m]
  double home = 0.0;       ///< [m]
  double enough = 0.0;     ///< until `kEnough` of the floor was seen; of the whole way if never [m]
  std::size_t tasks = 0;   ///< frontiers that it drove to, one after the other
  std::size_t in_vain = 0;  ///< of these, that showed nothing

  static constexpr double kEnough = 0.95;  ///< share of the floor that it can get to
};

/// What the robot was about at a tick of its drive.
struct TickOfTask {
  std::size_t task = 0;  ///< counts up where another target is taken; 0: it has none yet
  core::Explorer::Aim aim = core::Explorer::Aim::kFrontier;
  double way = 0.0;  ///< driven until then, backwards too [m], not falling
};

/// `seen`: share of the floor that was seen until each tick, not falling; `floor_area`: of all of
/// it [m^2].
ExploreAccount accountOf(const std::vector<TickOfTask>& ticks, const std::vector<double>& seen,
                         double floor_area);

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_ROUTES_EXPLORE_ACCOUNT_H
