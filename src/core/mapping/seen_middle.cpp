#include "core/mapping/seen_middle.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kAhead = 0.4;     ///< mean of unit vectors along the bearings, from which on it is
constexpr double kFarthest = 4.5;  ///< that fits on a grid beside the base [m]

}  // namespace

Pose2d seenMiddle(const std::vector<SonarReading>& readings) {
  double along = 0.0, aside = 0.0;
  double x = 0.0, y = 0.0, sum = 0.0;
  for (const SonarReading& reading : readings) {
    along += std::cos(reading.sensor_pose.yaw);
    aside += std::sin(reading.sensor_pose.yaw);
    const double range =
        std::clamp(reading.range, 0.0, std::min(reading.spec.max_range, kFarthest));
    const Pose2d middle = reading.sensor_pose * Pose2d{0.5 * range, 0.0, 0.0};
    x += range * middle.x;
    y += range * middle.y;
    sum += range;
  }
  const bool ahead = std::hypot(along, aside) > kAhead * static_cast<double>(readings.size());
  return ahead && sum > 0.0 ? Pose2d{x / sum, y / sum, 0.0} : Pose2d{};
}

}  // namespace place_memory::core
