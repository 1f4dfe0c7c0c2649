#include "node/input/heading_adapter.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "node/base/ros_time.h"
#include "node/input/frame_name.h"
#include "node/input/sensor_placement.h"

namespace place_memory::node {
namespace {

// tf may come later than the first messages.
constexpr int kPatience = 20;  // messages
// Of the field, the part that must lie level for its direction to mean something.
constexpr double kLeastLevel = 0.05;
constexpr double kLargestBearing = 720.0;  // [degrees]

struct Vector {
  double x, y, z;
};

Vector rotated(const geometry_msgs::Quaternion& q, const Vector& v) {
  const Vector t{2.0 * (q.y * v.z - q.z * v.y), 2.0 * (q.z * v.x - q.x * v.z),
                 2.0 * (q.x * v.y - q.y * v.x)};
  return {v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
          v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}

}  // namespace

CheckedHeading HeadingAdapter::adapt(const sensor_msgs::Imu& message,
                                     const tf2::BufferCore& transforms) {
  std::string ignored;  // without a frame it lies as the base does
  const std::string frame = frameName(message.header.frame_id, ignored);
  CheckedHeading heading =
      checkHeading(message, rotation(transforms, frame, parameters_->base_frame));
  if (parameters_->heading.reversed) heading.yaw = -heading.yaw;
  heading.yaw = corrected(heading.yaw);
  return heading;
}

CheckedHeading HeadingAdapter::adapt(const sensor_msgs::MagneticField& message,
                                     const tf2::BufferCore& transforms) {
  if (message.header.stamp.isZero()) return noHeading("its stamp is 0");
  const geometry_msgs::Vector3& field = message.magnetic_field;
  const double strength = std::hypot(std::hypot(field.x, field.y), field.z);
  if (!std::isfinite(strength)) return noHeading("its magnetic field is not finite");
  if (strength == 0.0) return noHeading("its magnetic field is 0");
  // Of length 1, so that whatever unit it has cannot overflow.
  Vector north{field.x / strength, field.y / strength, field.z / strength};
  std::string ignored;  // without a frame it lies as the base does
  const std::string frame = frameName(message.header.frame_id, ignored);
  const auto turned = rotation(transforms, parameters_->base_frame, frame);
  if (turned) north = rotated(*turned, north);
  if (std::hypot(north.x, north.y) < kLeastLevel) {
    return noHeading(
        "its magnetic field points up or down: is it mounted as tf says, and is no "
        "magnet or motor beside it?");
  }
  CheckedHeading heading;
  heading.stamp = toNanoseconds(message.header.stamp);
  // North lies so far to the robot's left as the robot looks clockwise of it.
  heading.yaw = yawOfBearing(std::atan2(north.y, north.x));
  return heading;
}

CheckedHeading HeadingAdapter::adapt(const std_msgs::Float64& message,
                                     std::chrono::nanoseconds received) const {
  if (!std::isfinite(message.data)) return noHeading("its bearing is not finite");
  if (std::abs(message.data) > kLargestBearing) {
    return noHeading("its bearing is " + std::to_string(message.data) +
                     ": it must be in degrees, clockwise from north");
  }
  CheckedHeading heading;
  heading.stamp = received;
  heading.yaw = yawOfBearing(message.data * core::kPi / 180.0);
  return heading;
}

std::optional<geometry_msgs::Quaternion> HeadingAdapter::rotation(const tf2::BufferCore& transforms,
                                                                  const std::string& target,
                                                                  const std::string& source) {
  if (target == source || target.empty() || source.empty()) return std::nullopt;
  try {
    const auto found = transforms.lookupTransform(target, source, ros::Time(0));
    without_frame_ = 0;
    frame_problem_.clear();
    return found.transform.rotation;
  } catch (const std::exception&) {  // tf2's own
    without_frame_ = std::min(without_frame_ + 1, kPatience);
  }
  if (without_frame_ == kPatience) {
    const std::string& frame = target == parameters_->base_frame ? source : target;
    frame_problem_ = "the frame " + frame +
                     " of the compass is not known to tf, so that it is taken to lie as " +
                     parameters_->base_frame + " does; " + knownFrames(transforms) +
                     ": publish how it is mounted, as by static_transform_publisher";
  }
  return std::nullopt;
}

double HeadingAdapter::yawOfBearing(double bearing) const {
  const config::HeadingOptions& options = parameters_->heading;
  const double clockwise = options.reversed ? -bearing : bearing;
  return corrected(core::kPi / 2.0 - (clockwise + options.declination));
}

double HeadingAdapter::corrected(double yaw) const {
  const double offset = parameters_->heading.yaw_offset;
  return core::wrapAngle(yaw + offset);
}

}  // namespace place_memory::node
