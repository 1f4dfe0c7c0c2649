#include "core/sensing/moved_readings.h"

namespace place_memory::core {

std::vector<SonarReading> movedReadings(const std::vector<SonarReading>& readings,
                                        const Pose2d& target_from_readings) {
  std::vector<SonarReading> moved = readings;
  for (SonarReading& reading : moved) {
    reading.sensor_pose = target_from_readings * reading.sensor_pose;
  }
  return moved;
}

}  // namespace place_memory::core
