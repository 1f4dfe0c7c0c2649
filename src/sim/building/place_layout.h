#ifndef PLACE_MEMORY_SIM_BUILDING_PLACE_LAYOUT_H
#define PLACE_MEMORY_SIM_BUILDING_PLACE_LAYOUT_H

#include <vector>

#include "sim/building/building_draft.h"
#include "sim/world/random.h"
#include "sim/world/world.h"

namespace place_memory::sim {

struct PlaceSpacing {
  double distance = 1.52;  ///< from place to place; the paper's regions are five feet across [m]
  double clearance = 0.3;  ///< free about every place [m]
  std::size_t most = 60;   ///< places of one building
};

/// Gives the world places all over its rooms, jittered off a lattice, linked where a robot can go
/// straight from one to the other with the doors open. Keeps one connected part and labels it from
/// "0".
void layPlaces(World& world, const std::vector<Room>& rooms, const PlaceSpacing& spacing, Rng& rng);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_BUILDING_PLACE_LAYOUT_H
