#ifndef PLACE_MEMORY_SIM_SCENE_WORLD_CHANGES_H
#define PLACE_MEMORY_SIM_SCENE_WORLD_CHANGES_H

#include <string>

#include "sim/world/random.h"
#include "sim/world/world.h"

namespace place_memory::sim {

/// The lasting changes of the paper's experiments. None of them covers a place: a disc of
/// kPlaceClearance about each place stays free.

/// Puts up to `count` new chairs about 1.8 m (six feet) from `around`, spread about it evenly as
/// far as what stands there permits (paper, section 5). Returns how many found room.
int addChairs(World& world, Vec2 around, int count, Rng& rng);

/// Opens or closes a share of the doors, [0, 1], drawn at random. Returns how many.
int flipDoors(World& world, double fraction, Rng& rng);

/// Moves a share of the chairs, [0, 1], by up to `distance` [m] each and turns them. Returns how
/// many moved.
int moveChairs(World& world, double fraction, double distance, Rng& rng);

/// Moves a share of the boxes and tables, [0, 1], by up to `distance` [m] each and turns them.
/// Returns how many moved.
int moveFurniture(World& world, double fraction, double distance, Rng& rng);

/// Parks `count` bicycles in free space within two metres of places. Returns how many.
int addBicycles(World& world, int count, Rng& rng);

/// False where the world has no such whiteboard.
bool removeWhiteboard(World& world, const std::string& name);

/// False where the world has no such door.
bool setDoor(World& world, const std::string& name, bool open);

/// Puts the chair there whatever else stands there. False where the world has no such chair.
bool moveChair(World& world, const std::string& name, const core::Pose2d& pose);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_WORLD_CHANGES_H
