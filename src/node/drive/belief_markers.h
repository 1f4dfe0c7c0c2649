#ifndef PLACE_MEMORY_NODE_DRIVE_BELIEF_MARKERS_H
#define PLACE_MEMORY_NODE_DRIVE_BELIEF_MARKERS_H

#include <geometry_msgs/Pose2D.h>
#include <place_memory/PlaceBelief.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

namespace place_memory::node {

/// The belief for rviz: a disc on each place that may be the robot's, the larger the more probable,
/// and over the first one the chances of being elsewhere in words. `locations` are those of
/// belief.ids in the frame of its header.
visualization_msgs::MarkerArray toMarkers(const PlaceBelief& belief,
                                          const std::vector<geometry_msgs::Pose2D>& locations);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_BELIEF_MARKERS_H
