#ifndef PLACE_MEMORY_CORE_SCAN_H
#define PLACE_MEMORY_CORE_SCAN_H

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// What the robot senses from one spot.
///
/// The scan frame has its origin where the robot's base stood when the scan began and its x axis
/// along compass east (paper 3.1.4: the grid lies along compass north).
struct Scan {
  std::uint64_t id = 0;  ///< tells scans of one process apart; 0: none was given
  std::vector<SonarReading> readings;
  /// The number of the sensor of each reading; empty where sensors are not told apart.
  std::vector<std::uint32_t> sensors;
  EvidenceGrid grid;         ///< of those readings, in the scan frame
  std::uint32_t echoes = 0;  ///< readings whose echo lies in the grid
  /// Pose of the scan frame in the odometry frame; identity where there is no odometry.
  Pose2d odom_from_scan;
  Pose2d robot_in_scan;  ///< where the robot's base stood when the scan ended
  /// Why it is not to be relied on, in a sentence: compass and odometry do not turn alike. Empty:
  /// nothing is known against it.
  std::string doubt;
  std::chrono::nanoseconds begin{0};
  std::chrono::nanoseconds end{0};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SCAN_H
