#ifndef PLACE_MEMORY_NODE_ANSWER_ANSWER_MARKERS_H
#define PLACE_MEMORY_NODE_ANSWER_ANSWER_MARKERS_H

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// A place as an answer weighs it.
struct LikelyPlace {
  core::Pose2d map_from_place;
  double probability = 0.0;
};

/// The places of an answer for rviz: a disc each under `likely`, the fuller the more probable, and
/// under `probability` how probable the first one is, in percent. `header`: of the map. What the
/// answer before it showed, and this one does not, goes.
visualization_msgs::MarkerArray toMarkers(const std::vector<LikelyPlace>& places,
                                          const std_msgs::Header& header);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_ANSWER_ANSWER_MARKERS_H
