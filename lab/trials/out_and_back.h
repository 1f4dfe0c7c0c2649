#ifndef PLACE_MEMORY_TRIALS_OUT_AND_BACK_H
#define PLACE_MEMORY_TRIALS_OUT_AND_BACK_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "trials/simulated_drive.h"

namespace place_memory::trials {

/// The longest of the shortest ways along a world's links: the indices of its places, from one end
/// to the other.
std::vector<std::size_t> longestWay(const sim::World& world);

/// A drive along places of a world, each linked with the next one, to the last of them and back,
/// repeatable by its seed. Doors are open; where something goes on standing in the way the robot
/// turns back there. Of the recipe `way`, `start`, `changes` and `carried` are not its matter.
Drive driveOutAndBack(sim::World world, const sim::SimulatedRobot& robot, DriveRecipe recipe,
                      const std::vector<std::size_t>& places, std::uint64_t seed);

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_OUT_AND_BACK_H
