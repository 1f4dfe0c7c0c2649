#include "sim/senses/simulated_scan.h"

#include <algorithm>

namespace place_memory::sim {

core::Pose2d sensorPose(const SensorRing& ring, int index) {
  if (!ring.mounts.empty()) return ring.mounts[static_cast<std::size_t>(index)];
  const double bearing = ring.first_bearing + ring.spacing * index;
  const Vec2 position = unitVector(bearing) * ring.radius;
  return {position.x, position.y, core::wrapAngle(bearing)};
}

std::vector<double> fireRing(const Scene& scene, const std::vector<Circle>& people,
                             const core::Pose2d& base, const SimulatedRobot& robot, Rng& rng) {
  const auto count = static_cast<std::size_t>(robot.ring.count);
  std::vector<double> own(count);
  for (std::size_t i = 0; i < count; ++i) {
    const core::Pose2d sensor = base * sensorPose(robot.ring, static_cast<int>(i));
    own[i] = pingSonar(scene, people, sensor, robot.ring.spec, robot.physics, rng);
  }
  std::vector<double> ranges = own;
  for (std::size_t i = 0; i < count; ++i) {
    const bool hears_neighbour = chance(rng, robot.physics.cross_talk);
    if (hears_neighbour && count > 1) ranges[i] = std::min(own[i], own[(i + 1) % count]);
  }
  return ranges;
}

std::vector<core::SonarReading> simulateScan(const Scene& scene, const core::Pose2d& base,
                                             double heading_error, const SimulatedRobot& robot,
                                             Crowd* crowd, Rng& rng) {
  static const std::vector<Circle> kNobody;
  std::vector<core::SonarReading> readings;
  readings.reserve(static_cast<std::size_t>(robot.sweep.headings) *
                   static_cast<std::size_t>(robot.ring.count));
  for (int set = 0; set < robot.sweep.headings; ++set) {
    const core::Pose2d turned{base.x, base.y, base.yaw + set * robot.sweep.step};
    const std::vector<double> ranges =
        fireRing(scene, crowd == nullptr ? kNobody : crowd->circles(), turned, robot, rng);
    const core::Pose2d in_scan{0.0, 0.0, turned.yaw + heading_error};
    for (int i = 0; i < robot.ring.count; ++i) {
      const double range = ranges[static_cast<std::size_t>(i)];
      if (range < robot.ring.spec.min_range) continue;
      readings.push_back({in_scan * sensorPose(robot.ring, i), robot.ring.spec, range});
    }
    if (crowd != nullptr) crowd->step(robot.sweep.set_period, {base.x, base.y}, rng);
  }
  return readings;
}

}  // namespace place_memory::sim
