#ifndef PLACE_MEMORY_SIM_WORLD_WORLD_TRANSFORM_H
#define PLACE_MEMORY_SIM_WORLD_WORLD_TRANSFORM_H

#include "place_memory/core/pose2d.h"
#include "sim/world/world.h"

namespace place_memory::sim {

/// Moves everything in the world by `by`: turned about the origin, then shifted.
void transformWorld(World& world, const core::Pose2d& by);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_WORLD_WORLD_TRANSFORM_H
