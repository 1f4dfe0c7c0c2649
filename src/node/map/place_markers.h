#ifndef PLACE_MEMORY_NODE_MAP_PLACE_MARKERS_H
#define PLACE_MEMORY_NODE_MAP_PLACE_MARKERS_H

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>

#include "place_memory/core/place_memory.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// The map for rviz, in few markers however many places there are: the regions of all places, five
/// feet across (paper 7), are one list of spheres under `regions`, where they lie one under
/// `places`, the links one list of lines under `links`. Each session has a colour. Under `labels`
/// are the labels of those places nearest to the robot that leave each other room, `labels` at
/// most; the id is the place's.
///
/// The first marker deletes all others, so that the latest array is the whole map for whoever gets
/// it, and what was removed vanishes.
visualization_msgs::MarkerArray toMarkers(const core::MapSnapshot& map,
                                          const core::Pose2d& map_from_robot, std::size_t labels,
                                          const std_msgs::Header& header);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_PLACE_MARKERS_H
