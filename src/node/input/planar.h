#ifndef PLACE_MEMORY_NODE_INPUT_PLANAR_H
#define PLACE_MEMORY_NODE_INPUT_PLANAR_H

#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>

#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// A pose in space as seen from above.
struct PlanarPose {
  core::Pose2d pose;         ///< yaw is that of the x axis
  bool upside_down = false;  ///< its z axis points down: left is right
  double level = 1.0;        ///< length of the x axis as seen from above, in [0, 1]; 1: horizontal
};

/// The rotation must be finite and not zero.
PlanarPose planar(const geometry_msgs::Transform& transform);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_PLANAR_H
