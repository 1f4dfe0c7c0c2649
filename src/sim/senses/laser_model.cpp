#include "sim/senses/laser_model.h"

#include <limits>

#include "sim/senses/sonar_physics.h"

namespace place_memory::sim {

std::vector<double> laserRanges(const Scene& scene, const std::vector<Circle>& people,
                                const core::Pose2d& pose, const LaserModel& laser, Rng& rng) {
  const double step = 2.0 * core::kPi / laser.rays;
  const core::SonarSpec spec{step, laser.min_range, laser.max_range};
  std::vector<double> ranges;
  ranges.reserve(static_cast<std::size_t>(laser.rays));
  for (int i = 0; i < laser.rays; ++i) {
    const Ray ray{{pose.x, pose.y}, unitVector(pose.yaw + i * step)};
    RayHit hit = scene.cast(ray, laser.max_range * 1.05, {}, nullptr);
    for (const Circle& person : people) testCircle(ray, person, {}, hit, nullptr);
    const double noise = laser.noise * normal(rng);
    const bool dropped = chance(rng, laser.drop_probability);
    ranges.push_back(hit.blocked && !dropped ? clampToSpec(hit.distance + noise, spec)
                                             : std::numeric_limits<double>::infinity());
  }
  return ranges;
}

std::vector<core::SonarReading> simulateLaserScan(const Scene& scene,
                                                  const std::vector<Circle>& people,
                                                  const core::Pose2d& pose, double heading_error,
                                                  const LaserModel& laser, Rng& rng) {
  const double step = 2.0 * core::kPi / laser.rays;
  const core::SonarSpec spec{step, laser.min_range, laser.max_range};
  const std::vector<double> ranges = laserRanges(scene, people, pose, laser, rng);
  std::vector<core::SonarReading> readings;
  readings.reserve(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i] < spec.min_range) continue;
    const double bearing = pose.yaw + heading_error + static_cast<double>(i) * step;
    readings.push_back({{0.0, 0.0, core::wrapAngle(bearing)}, spec, ranges[i]});
  }
  return readings;
}

}  // namespace place_memory::sim
