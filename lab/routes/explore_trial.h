#ifndef PLACE_MEMORY_ROUTES_EXPLORE_TRIAL_H
#define PLACE_MEMORY_ROUTES_EXPLORE_TRIAL_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/explore/explorer.h"
#include "core/map/kept_map.h"
#include "mapping/mapping_figures.h"
#include "routes/explore_account.h"
#include "sim/world/world.h"
#include "trials/simulated_drive.h"

namespace place_memory::routes {

struct ExploreRecipe {
  trials::DriveRecipe drive;
  core::ExplorerOptions explorer;
  bool compass = true;
  double radius = 0.25;       ///< that the leg driver keeps free [m]
  double clearance = 0.1;     ///< likewise, ahead [m]
  double most_time = 7200.0;  ///< after which it is stopped [s]
};

/// What became of an exploration.
struct ExploreResult {
  bool is_done = false;        ///< it said so
  bool is_home = false;        ///< it stands within a metre of where it began
  std::string ended;           ///< how, in words
  double way = 0.0;            ///< driven in truth, backwards too [m]
  double seen = 0.0;           ///< share of the floor that it can get to, see TrueFloor
  double tour = 0.0;           ///< of a robot that knows the floor, to see as much [m]
  std::size_t viewpoints = 0;  ///< of that tour
  ExploreAccount account;
  double time = 0.0;              ///< [s]
  std::size_t blocked = 0;        ///< times
  std::size_t loops = 0;          ///< gone back for
  double decision = 0.0;          ///< mean cost of deciding where to drive [ms]
  double longest_decision = 0.0;  ///< [ms]
  mapping::MappingFigures map;
  std::vector<core::Explorer::Left> left;
  core::KeptMap kept;
  std::vector<core::Pose2d> way_in_truth;
};

/// A simulated robot explores a world from its first place, with an empty map.
ExploreResult explore(const sim::World& world, const ExploreRecipe& recipe, std::uint64_t seed);

}  // namespace place_memory::routes

#endif  // PLACE_MEMORY_ROUTES_EXPLORE_TRIAL_H
