#ifndef PLACE_MEMORY_MAPPING_MAPPING_WORLDS_H
#define PLACE_MEMORY_MAPPING_MAPPING_WORLDS_H

#include <cstdint>
#include <string>

#include "sim/world/world.h"

namespace place_memory::mapping {

/// A room of 11 by 7.5 m that looks nearly the same turned by half a turn, to be driven about in
/// circles.
sim::World halfTurnRoom();

/// A corridor with `cells` rooms on each side, one like the other but for what stands in them; and
/// where `copied` is above 0 that too is the same in such a share of them.
sim::World alikeCells(int cells, std::uint64_t seed, double copied = 0.0);

/// By its name: "half_turn", "cells", "copied_cells", "corridor", "open_plan", "laboratory",
/// "home", made by the seed, a world file's path, or a file of the folder `worlds` without its
/// ending. Throws sim::WorldError where there is none such.
sim::World mappingWorld(const std::string& name, std::uint64_t seed, const std::string& worlds);

}  // namespace place_memory::mapping

#endif  // PLACE_MEMORY_MAPPING_MAPPING_WORLDS_H
