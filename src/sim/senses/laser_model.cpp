#include "sim/senses/laser_model.h"

#include <limits>

#include "sim/senses/sonar_physics.h"

namespace place_memory::sim {

std::vector<core::SonarReading> simulateLaserScan(const Scene& scene,
                                                  const std::vector<Circle>& people,
                                                  const core::Pose2d& pose, double heading_error,
                                                  const LaserModel& laser, Rng& rng) {
  const double step = 2.0 * core::kPi / laser.rays;
  const core::SonarSpec spec{step, laser.min_range, laser.max_range};
  std::vector<core::SonarReading> readings;
  readings.reserve(static_cast<std::size_t>(laser.rays));
  for (int i = 0; i < laser.rays; ++i) {
    const Ray ray{{pose.x, pose.y}, unitVector(pose.yaw + i * step)};
    RayHit hit = scene.cast(ray, laser.max_range * 1.05, {}, nullptr);
    for (const Circle& person : people) testCircle(ray, person, {}, hit, nullptr);
    const double noise = laser.noise * normal(rng);
    const bool dropped = chance(rng, laser.drop_probability);
    const double range = hit.blocked && !dropped ? clampToSpec(hit.distance + noise, spec)
                                                 : std::numeric_limits<double>::infinity();
    if (range < spec.min_range) continue;
    readings.push_back(
        {{0.0, 0.0, core::wrapAngle(pose.yaw + heading_error + i * step)}, spec, range});
  }
  return readings;
}

}  // namespace place_memory::sim
