#ifndef PLACE_MEMORY_NODE_INPUT_HEADING_CHECK_H
#define PLACE_MEMORY_NODE_INPUT_HEADING_CHECK_H

#include <sensor_msgs/Imu.h>

#include <chrono>
#include <optional>
#include <string>

namespace place_memory::node {

struct CheckedHeading {
  std::chrono::nanoseconds stamp{0};
  double yaw = 0.0;                    ///< REP 103 [rad]
  std::optional<std::string> problem;  ///< why the message holds no heading, in a sentence
};

/// That there is no heading, and why.
CheckedHeading noHeading(const std::string& problem);

/// Yaw of the robot's x axis; `imu_from_base` is how the robot lies in the Imu's frame, nothing: as
/// the Imu itself. Only stamp and orientation of the message are looked at. A quaternion that is
/// slightly off norm is normalised.
CheckedHeading checkHeading(
    const sensor_msgs::Imu& message,
    const std::optional<geometry_msgs::Quaternion>& imu_from_base = std::nullopt);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_HEADING_CHECK_H
