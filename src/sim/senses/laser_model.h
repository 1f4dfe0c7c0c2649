#ifndef PLACE_MEMORY_SIM_SENSES_LASER_MODEL_H
#define PLACE_MEMORY_SIM_SENSES_LASER_MODEL_H

#include <vector>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"
#include "sim/scene/scene.h"
#include "sim/world/random.h"

namespace place_memory::sim {

/// A laser rangefinder, the sensor the paper plans to use next (section 9): every surface scatters
/// light back, so the nearest thing along a thin ray is the range.
struct LaserModel {
  int rays = 360;            ///< evenly over the full turn, >= 1
  double min_range = 0.05;   ///< [m]
  double max_range = 4.572;  ///< [m]; the paper's grid reaches no further
  double noise = 0.01;       ///< 1 sigma [m], >= 0
  double drop_probability = 0.002;
};

/// One turn of the laser from `pose` (world): the range of each ray counter-clockwise from straight
/// ahead [m], infinities by REP 117.
std::vector<double> laserRanges(const Scene& scene, const std::vector<Circle>& people,
                                const core::Pose2d& pose, const LaserModel& laser, Rng& rng);

/// The same as readings with narrow cones in the scan frame:
/// origin at `pose`, x axis along compass east, the compass erring by `heading_error` [rad].
std::vector<core::SonarReading> simulateLaserScan(const Scene& scene,
                                                  const std::vector<Circle>& people,
                                                  const core::Pose2d& pose, double heading_error,
                                                  const LaserModel& laser, Rng& rng);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SENSES_LASER_MODEL_H
