#include "core/drive/echo_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_memory::core {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

void EchoRing::hear(SensorId sensor, std::chrono::nanoseconds stamp, const Pose2d& base_from_sensor,
                    double range) {
  const long bearing = std::lround(wrapAngle(base_from_sensor.yaw) * 180.0 / kPi);
  heard_[{sensor, bearing}] = {stamp, base_from_sensor, range};
}

template <class Take>
void EchoRing::forEachEcho(std::chrono::nanoseconds now, const Take& take) const {
  for (const auto& [sensor, heard] : heard_) {
    if (now - heard.stamp > memory_ || !std::isfinite(heard.range)) continue;
    const Pose2d echo = heard.base_from_sensor * Pose2d{heard.range, 0.0, 0.0};
    take(echo.x, echo.y);
  }
}

bool EchoRing::isBlind(std::chrono::nanoseconds now) const {
  return std::none_of(heard_.begin(), heard_.end(), [&](const auto& item) {
    const Heard& heard = item.second;
    return now - heard.stamp <= memory_ && std::cos(heard.base_from_sensor.yaw) > 0.0;
  });
}

double EchoRing::along(std::chrono::nanoseconds now, double bearing, double half_width) const {
  double nearest = kFar;
  const Pose2d way_from_base = Pose2d{0.0, 0.0, bearing}.inverse();
  forEachEcho(now, [&](double x, double y) {
    const Pose2d echo = way_from_base * Pose2d{x, y, 0.0};
    if (echo.x > 0.0 && std::abs(echo.y) < half_width) nearest = std::min(nearest, echo.x);
  });
  return nearest;
}

bool EchoRing::looks(std::chrono::nanoseconds now, double bearing, double within) const {
  return std::any_of(heard_.begin(), heard_.end(), [&](const auto& item) {
    const Heard& heard = item.second;
    return now - heard.stamp <= memory_ &&
           std::abs(wrapAngle(heard.base_from_sensor.yaw - bearing)) <= within;
  });
}

double EchoRing::beside(std::chrono::nanoseconds now, double side, double reach) const {
  double nearest = kFar;
  forEachEcho(now, [&](double x, double y) {
    if (x > 0.0 && x < reach && side * y > 0.0) nearest = std::min(nearest, side * y);
  });
  return nearest;
}

}  // namespace place_memory::core
