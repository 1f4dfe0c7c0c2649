#ifndef PLACE_MEMORY_NODE_BASE_CONVERSIONS_H
#define PLACE_MEMORY_NODE_BASE_CONVERSIONS_H

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Pose2D.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <nav_msgs/OccupancyGrid.h>
#include <place_memory/Recognition.h>
#include <ros/duration.h>
#include <ros/time.h>
#include <std_msgs/Header.h>

#include <array>
#include <chrono>
#include <string>

#include "config/parameters.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

/// The nearest time a message can hold: from 0 to the year 2106.
ros::Time toRosTime(std::chrono::nanoseconds time);

std_msgs::Header makeHeader(const std::string& frame_id, const ros::Time& stamp);

geometry_msgs::Pose toPose(const core::Pose2d& pose);
geometry_msgs::Pose2D toPose2D(const core::Pose2d& pose);

/// `covariance`: row-major 3 x 3 over x, y, yaw. Height, roll and pitch are 0 and certain.
geometry_msgs::PoseWithCovariance toPoseWithCovariance(const core::Pose2d& pose,
                                                       const std::array<double, 9>& covariance);

/// The grid in the frame of the header, where its own frame has the pose `frame_from_grid`. Cells
/// without evidence are -1, the others probability of occupancy in percent, given a prior in (0,
/// 1).
nav_msgs::OccupancyGrid toOccupancyGrid(const core::EvidenceGrid& grid,
                                        const core::Pose2d& frame_from_grid,
                                        const std_msgs::Header& header, double prior);

Recognition toMessage(const core::PlaceMemory::Answer& answer, const std_msgs::Header& header,
                      const ros::Duration& match_duration);

/// The frame in which scans lie: that of odometry, where there is one.
const std::string& scanFrame(const config::Parameters& parameters);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_CONVERSIONS_H
