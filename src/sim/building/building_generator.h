#ifndef PLACE_MEMORY_SIM_BUILDING_BUILDING_GENERATOR_H
#define PLACE_MEMORY_SIM_BUILDING_BUILDING_GENERATOR_H

#include <cstdint>

#include "sim/world/world.h"

namespace place_memory::sim {

enum class BuildingKind {
  kCorridor,    ///< corridors, straight or bent, with offices on both sides
  kOpenPlan,    ///< one large hall full of desks and partitions, offices around it
  kLaboratory,  ///< large rooms in a row with benches, a passage along them
  kHome,        ///< small rooms with doors between them
  kArena,       ///< two to four metres of walls for a small robot
};

constexpr int kBuildingKinds = 5;

/// A random building of a random kind, repeatable by its seed: sizes, plans, furniture, materials,
/// door states and the angle to north all vary. It has at least four places, all free to stand at,
/// linked where one can be walked to from the other with the doors open; they form one connected
/// graph.
World generateBuilding(std::uint64_t seed);

/// The same, of the given kind.
World generateBuilding(BuildingKind kind, std::uint64_t seed);

/// The room that places of such buildings leave to a robot [m].
double placeClearance(BuildingKind kind);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_BUILDING_BUILDING_GENERATOR_H
