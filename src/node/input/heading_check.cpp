#include "node/input/heading_check.h"

#include <cmath>

#include "node/input/planar.h"

namespace place_memory::node {
namespace {

constexpr double kNormSlack = 0.1;
constexpr double kLeastLevel = 0.1;

CheckedHeading problem(const std::string& text) {
  CheckedHeading heading;
  heading.problem = text;
  return heading;
}

}  // namespace

CheckedHeading checkHeading(const sensor_msgs::Imu& message) {
  if (message.header.stamp.isZero()) return problem("its stamp is 0");
  if (message.orientation_covariance[0] == -1.0) {
    return problem("it has no orientation (orientation_covariance[0] is -1)");
  }
  const geometry_msgs::Quaternion& q = message.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!std::isfinite(norm)) return problem("its quaternion is not finite");
  if (std::abs(norm - 1.0) > kNormSlack) {
    return problem("its quaternion has a norm of " + std::to_string(norm) + ", not 1");
  }
  geometry_msgs::Transform rotation;
  rotation.rotation = q;
  const PlanarPose pose = planar(rotation);
  if (pose.level < kLeastLevel) return problem("its x axis points up or down");
  CheckedHeading heading;
  heading.yaw = pose.pose.yaw;
  return heading;
}

}  // namespace place_memory::node
