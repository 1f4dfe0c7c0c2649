#ifndef PLACE_MEMORY_CORE_RECOGNIZE_POSE_ESTIMATE_H
#define PLACE_MEMORY_CORE_RECOGNIZE_POSE_ESTIMATE_H

#include <Eigen/Core>

#include "core/match/alignment_search.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// A pose between the lattice's points, and how sure it is.
struct PoseEstimate {
  Pose2d place_from_scan;
  /// Over x [m], y [m], yaw [rad], in the place's frame. Never less than what the lattice cannot
  /// tell.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// Mean and spread of the transforms about `best`, up to four cells and three heading steps away
/// where they count for anything, each weighing exp(sharpness * score). Sharpness [1 / score], >=
/// 0.
PoseEstimate estimatePose(const QueryPlanes& query, const CellPlanes& learned,
                          const LatticeMetric& metric, const SearchWindow& window,
                          const Alignment& best, double cell_size, double sharpness);

/// Where the robot stands, and how sure that is: row-major over x [m], y [m], yaw [rad] in the map.
struct RobotPose {
  Pose2d map_from_robot;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// Compounds the estimate with where the place lies and with where the robot's base stood in the
/// scan, both taken as certain (Smith, Self and Cheeseman, Estimating Uncertain Spatial
/// Relationships in Robotics, 1990): by how much the heading is off moves a robot that stands away
/// from the scan's origin.
RobotPose robotPose(const Pose2d& map_from_place, const PoseEstimate& estimate,
                    const Pose2d& robot_in_scan);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_POSE_ESTIMATE_H
