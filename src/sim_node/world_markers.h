#ifndef PLACE_MEMORY_SIM_NODE_WORLD_MARKERS_H
#define PLACE_MEMORY_SIM_NODE_WORLD_MARKERS_H

#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace place_memory::sim_node {

/// The surfaces, as lines, and the round things of a world.
visualization_msgs::MarkerArray toMarkers(const sim::Scene& scene, const std::string& frame);

visualization_msgs::Marker toMarker(const std::vector<sim::Circle>& people,
                                    const std::string& frame);

}  // namespace place_memory::sim_node

#endif  // PLACE_MEMORY_SIM_NODE_WORLD_MARKERS_H
