#include "node/input/cloud_adapter.h"

#include <cmath>
#include <limits>

#include "node/base/ros_time.h"
#include "node/input/echo_dialect.h"
#include "node/input/frame_name.h"

namespace place_memory::node {
namespace {

constexpr double kOrigin = 1e-3;  // a point so near to it is there [m]
constexpr double kOnAxis = 0.01;  // a point so near to a sonar's axis may be meant to lie on it [m]

// A range of more times max_range is no word for no echo but of another unit, but for the largest
// values there are.
constexpr double kFarBeyond = 10.0;
constexpr double kDistance = 1e6;  // [m]

// Mounts by a table are some centimetres and degrees off, and so are echoes at the edge of a cone.
constexpr double kAside = 0.3;               // [m]
constexpr double kTurned = core::kPi / 4.0;  // [rad]

/// The range that the driver means: one of 0 or less puts the point on the sonar or behind it.
double rangeOf(const core::Pose2d& in_sensor) {
  const double range = std::hypot(in_sensor.x, in_sensor.y);
  if (range <= kOrigin) return 0.0;
  return in_sensor.x < 0.0 && std::abs(in_sensor.y) <= kOnAxis ? -range : range;
}

/// What is wrong with an echo that a sonar so mounted cannot hear; empty: it can.
std::string misplaced(const core::Pose2d& in_sensor) {
  const double bearing = std::atan2(in_sensor.y, in_sensor.x);
  if (std::hypot(in_sensor.x, in_sensor.y) <= kAside || std::abs(bearing) <= kTurned) return {};
  return "its points lie " + std::to_string(std::lround(std::abs(bearing) / core::kPi * 180.0)) +
         " degrees to the " + (bearing > 0.0 ? "left" : "right") +
         " of where cloud/mounts says that it looks: are their order, signs and unit right, and is "
         "the frame that of the base?";
}

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
    adapted.sensor_problem =
        "its cloud holds " + std::to_string(points.points.size()) + " points, but cloud/mounts " +
        std::to_string(mounts) +
        " poses: give it one for each point, or [], by which they are inferred";
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
  const core::Pose2d in_sensor = mount->inverse() * core::Pose2d{point.x, point.y, 0.0};
  measurement.range = rangeOf(in_sensor);
  const double range = measurement.range;
  if (range > kFarBeyond * options.max_range && range < kDistance &&
      !parameters_->scan.over_range_is_no_echo) {
    reading.reject = Reject::kAboveMaxRange;
  } else if (!isEcho(point, range, options.max_range)) {
    measurement.range = std::numeric_limits<double>::infinity();
  } else if (range <= 0.0) {
    if (parameters_->no_echo.zero) {
      reading.no_echo = NoEchoWord{range, "which no echo can have"};
      measurement.range = std::numeric_limits<double>::infinity();
    } else if (range < 0.0) {
      reading.reject = Reject::kBelowMinRange;
    }
  } else if (!options.mounts.empty()) {
    reading.sensor_problem = misplaced(in_sensor);
    if (!reading.sensor_problem.empty()) reading.reject = Reject::kBadSensor;
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
