#ifndef PLACE_MEMORY_SIM_SCENE_SCENE_BUILDER_H
#define PLACE_MEMORY_SIM_SCENE_SCENE_BUILDER_H

#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace place_memory::sim {

struct SceneShapes {
  std::vector<Segment> segments;
  std::vector<Circle> circles;
};

/// The surfaces of everything in the world: walls with their door openings cut out, door panels
/// where they stand, legs of chairs and tables, with the joints between segments worked out.
SceneShapes buildShapes(const World& world);

/// The free edge of the door panel as it stands.
Vec2 doorEdge(const Door& door);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_SCENE_BUILDER_H
