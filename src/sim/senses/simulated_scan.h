#ifndef PLACE_MEMORY_SIM_SENSES_SIMULATED_SCAN_H
#define PLACE_MEMORY_SIM_SENSES_SIMULATED_SCAN_H

#include <vector>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"
#include "sim/scene/crowd.h"
#include "sim/scene/scene.h"
#include "sim/senses/sonar_physics.h"
#include "sim/world/random.h"

namespace place_memory::sim {

/// Sonars around a base, all firing together.
struct SensorRing {
  int count = 16;                            ///< >= 1
  double first_bearing = 0.0;                ///< of sensor 0 from the base's x axis [rad]
  double spacing = core::kPi / 8.0;          ///< bearing from one sensor to the next [rad]
  double radius = 0.22;                      ///< of the ring, base to sensor [m], >= 0
  core::SonarSpec spec{0.436, 0.15, 4.572};  ///< 25 degrees, 6 inches to 15 feet
  /// Where each sensor is in the base frame, if not evenly about a circle; none: as above.
  std::vector<core::Pose2d> mounts{};
};

/// How the base turns through a scan (paper 3.1.4: eleven sets at two degrees).
struct Sweep {
  int headings = 11;               ///< sets of readings, >= 1
  double step = core::kPi / 90.0;  ///< turn from one set to the next [rad]
  double set_period = 0.9;         ///< time from one set to the next [s], > 0
};

struct SimulatedRobot {
  SensorRing ring;
  Sweep sweep;
  SonarPhysics physics;
};

/// Pose of sensor `index` of the ring in the base frame.
core::Pose2d sensorPose(const SensorRing& ring, int index);

/// One firing of the whole ring from the base's pose in the world, by sensor; infinities by REP
/// 117.
std::vector<double> fireRing(const Scene& scene, const std::vector<Circle>& people,
                             const core::Pose2d& base, const SimulatedRobot& robot, Rng& rng);

/// A place scan. The base stands at `base` (world) and turns by the sweep; `crowd` (may be null)
/// walks meanwhile and gives way to it. The readings come in the scan frame: origin at the base, x
/// axis along compass east, where the compass shows the true heading plus `heading_error` [rad].
/// Echoes below the minimum range are left out.
std::vector<core::SonarReading> simulateScan(const Scene& scene, const core::Pose2d& base,
                                             double heading_error, const SimulatedRobot& robot,
                                             Crowd* crowd, Rng& rng);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SENSES_SIMULATED_SCAN_H
