#ifndef PLACE_MEMORY_CORE_SENSING_MEASUREMENT_H
#define PLACE_MEMORY_CORE_SENSING_MEASUREMENT_H

#include <chrono>
#include <cstdint>
#include <string>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// Tells sensors apart. Whoever knows their names hands out the numbers, each once.
using SensorId = std::uint32_t;

/// What every kind of sensor message becomes before anything else is done with it: one distance
/// along one cone, not yet located.
struct Measurement {
  std::chrono::nanoseconds stamp{0};
  std::string frame;  ///< in which the sensor's pose is given
  SensorId sensor = 0;
  Pose2d frame_from_sensor;  ///< x axis along the cone
  SonarSpec spec;
  double range = 0.0;  ///< as SonarReading::range
};

/// A measurement of which is known where it was taken. The fixed frame is that of odometry; where
/// there is none, the robot's base turns about its origin.
struct LocatedReading {
  std::chrono::nanoseconds stamp{0};
  SensorId sensor = 0;
  Pose2d fixed_from_base;  ///< of the robot at the stamp
  SonarReading reading;    ///< with the sensor's pose in the fixed frame
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_MEASUREMENT_H
