#ifndef PLACE_MEMORY_TEST_CORE_SENSING_SWEEP_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_SENSING_SWEEP_FIXTURE_H

#include "core/sensing/measurement.h"

namespace place_memory::core {

constexpr double kStep = kPi / 90.0;

// A reading of a sensor that looks ahead from the robot's middle.
inline LocatedReading located(std::chrono::nanoseconds stamp, SensorId sensor,
                              const Pose2d& fixed_from_base, double range = 1.0) {
  LocatedReading reading;
  reading.stamp = stamp;
  reading.sensor = sensor;
  reading.fixed_from_base = fixed_from_base;
  reading.reading.sensor_pose = fixed_from_base;
  reading.reading.spec = {0.4, 0.1, 4.0};
  reading.reading.range = range;
  return reading;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_SENSING_SWEEP_FIXTURE_H
