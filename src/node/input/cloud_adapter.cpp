#include "node/input/cloud_adapter.h"

#include <cmath>
#include <limits>

#include "node/base/ros_time.h"
#include "node/input/echo_dialect.h"
#include "node/input/frame_name.h"

namespace place_memory::node {
namespace {

constexpr double kOrigin = 1e-3;  // a point so near to it is there [m]

bool isEcho(const CloudPoint& point, double range, double max_range) {
  return std::hypot(point.x, point.y) > kOrigin && range < max_range &&
         !isMaxRange(range, max_range);
}

}  // namespace

std::vector<AdaptedReading> CloudAdapter::adapt(const std_msgs::Header& header,
                                                const CloudPoints& points) {
  AdaptedReading adapted;
  adapted.measurement.stamp = toNanoseconds(header.stamp);
  adapted.sensor_problem = points.problem;
  adapted.measurement.frame = frameName(header.frame_id, adapted.sensor_problem);
  if (adapted.measurement.frame.empty()) adapted.measurement.frame = parameters_->base_frame;
  const std::size_t mounts = parameters_->cloud.mounts.size();
  if (adapted.sensor_problem.empty() && mounts > 0 && mounts != points.points.size()) {
    adapted.sensor_problem = "its cloud holds " + std::to_string(points.points.size()) +
                             " points, but cloud/mounts " + std::to_string(mounts) + " poses";
  }
  if (!adapted.sensor_problem.empty()) {
    adapted.measurement.sensor = registry_->idOf(topic_, adapted.measurement.frame);
    adapted.reject = Reject::kBadSensor;
    return {adapted};
  }
  if (rays_.size() != points.points.size()) rays_.assign(points.points.size(), RayFit());
  std::vector<AdaptedReading> readings;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    AdaptedReading& reading = readings.emplace_back(adapted);
    reading.measurement.sensor =
        registry_->idOf(topic_, adapted.measurement.frame, static_cast<int>(i));
    if (header.stamp.isZero()) {
      reading.reject = Reject::kNoStamp;
    } else {
      measure(i, points.points[i], reading);
    }
  }
  return readings;
}

void CloudAdapter::measure(std::size_t index, const CloudPoint& point, AdaptedReading& reading) {
  if (std::isnan(point.x) || std::isnan(point.y)) {
    reading.reject = Reject::kNan;
    return;
  }
  const config::CloudOptions& options = parameters_->cloud;
  core::Measurement& measurement = reading.measurement;
  measurement.spec = {options.field_of_view, 0.0, options.max_range};
  const auto mount = mountOf(index, point);
  if (!mount) {
    reading.reject = Reject::kNoMount;
    return;
  }
  measurement.frame_from_sensor = *mount;
  measurement.range = std::hypot(point.x - mount->x, point.y - mount->y);
  if (!isEcho(point, measurement.range, options.max_range)) {
    measurement.range = std::numeric_limits<double>::infinity();
  }
}

std::optional<core::Pose2d> CloudAdapter::mountOf(std::size_t index, const CloudPoint& point) {
  const config::CloudOptions& options = parameters_->cloud;
  if (!options.mounts.empty()) return options.mounts[index];
  RayFit& ray = rays_[index];
  const double far = std::hypot(point.x, point.y);
  if (isEcho(point, far, options.max_range)) ray.add(point);
  if (const auto mount = ray.mount()) return mount;
  // No echo yet, but the point at the end of the cone says where that lies.
  if (!std::isfinite(far) || far <= kOrigin) return std::nullopt;
  return core::Pose2d{0.0, 0.0, std::atan2(point.y, point.x)};
}

}  // namespace place_memory::node
