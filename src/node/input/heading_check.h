#ifndef PLACE_MEMORY_NODE_INPUT_HEADING_CHECK_H
#define PLACE_MEMORY_NODE_INPUT_HEADING_CHECK_H

#include <sensor_msgs/Imu.h>

#include <optional>
#include <string>

namespace place_memory::node {

struct CheckedHeading {
  double yaw = 0.0;                    ///< REP 103 [rad]
  std::optional<std::string> problem;  ///< why the message holds no heading, in a sentence
};

/// Yaw of the orientation's x axis; other parts of the message are not looked at. A quaternion that
/// is slightly off norm is normalised.
CheckedHeading checkHeading(const sensor_msgs::Imu& message);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_HEADING_CHECK_H
