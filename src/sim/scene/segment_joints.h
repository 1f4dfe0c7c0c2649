#ifndef PLACE_MEMORY_SIM_SCENE_SEGMENT_JOINTS_H
#define PLACE_MEMORY_SIM_SCENE_SEGMENT_JOINTS_H

#include <vector>

#include "sim/scene/scene.h"

namespace place_memory::sim {

/// Fills in the ends of all segments: which others meet there and whether the surface runs straight
/// on.
void joinSegments(std::vector<Segment>& segments);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_SEGMENT_JOINTS_H
