#ifndef PLACE_MEMORY_CORE_MAPPING_ODOMETRY_REACH_H
#define PLACE_MEMORY_CORE_MAPPING_ODOMETRY_REACH_H

#include <Eigen/Core>
#include <vector>

#include "core/mapping/scan_graph.h"

namespace place_memory::core {

/// Covariance of where a way through the graph puts its first node beside its last one, over x [m],
/// y [m], yaw [rad] in the map: each turn that odometry mistook moves what came after it by its
/// lever, so that a robot that goes to and fro in a room is better known than one that drove as far
/// along a corridor. `compass`: one that agrees holds the heading.
Eigen::Matrix3d wayCovariance(const ScanGraph& graph, const std::vector<NodeIndex>& way,
                              bool compass);

/// By how many sigmas of the way a pose of its first node is off from where the graph has it.
double sigmasOff(const ScanGraph& graph, const std::vector<NodeIndex>& way, bool compass,
                 const Pose2d& pose);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_ODOMETRY_REACH_H
