#ifndef PLACE_MEMORY_NODE_MAP_PLACE_MARKERS_H
#define PLACE_MEMORY_NODE_MAP_PLACE_MARKERS_H

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The map for rviz: the region of each place five feet across (paper 7) under `regions`, labels
/// under `labels`, links under `links`; the id of a marker is its place's.
///
/// The first marker deletes all others, so that the latest array is the whole map for whoever gets
/// it, and what was removed vanishes.
visualization_msgs::MarkerArray toMarkers(const core::MapSnapshot& map,
                                          const std_msgs::Header& header);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_PLACE_MARKERS_H
