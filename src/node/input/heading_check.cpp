#include "node/input/heading_check.h"

#include <cmath>

#include "node/base/ros_time.h"
#include "node/input/planar.h"

namespace place_memory::node {
namespace {

constexpr double kNormSlack = 0.1;
constexpr double kLeastLevel = 0.1;

geometry_msgs::Quaternion product(const geometry_msgs::Quaternion& a,
                                  const geometry_msgs::Quaternion& b) {
  geometry_msgs::Quaternion c;
  c.w = a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z;
  c.x = a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y;
  c.y = a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x;
  c.z = a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w;
  return c;
}

}  // namespace

CheckedHeading noHeading(const std::string& problem) {
  CheckedHeading heading;
  heading.problem = problem;
  return heading;
}

CheckedHeading checkHeading(const sensor_msgs::Imu& message,
                            const std::optional<geometry_msgs::Quaternion>& imu_from_base) {
  if (message.header.stamp.isZero()) return noHeading("its stamp is 0");
  if (message.orientation_covariance[0] == -1.0) {
    return noHeading("it has no orientation (orientation_covariance[0] is -1)");
  }
  const geometry_msgs::Quaternion& q = message.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!std::isfinite(norm)) return noHeading("its quaternion is not finite");
  if (std::abs(norm - 1.0) > kNormSlack) {
    return noHeading("its quaternion has a norm of " + std::to_string(norm) + ", not 1");
  }
  geometry_msgs::Transform rotation;
  rotation.rotation = imu_from_base ? product(q, *imu_from_base) : q;
  const PlanarPose pose = planar(rotation);
  if (pose.level < kLeastLevel) return noHeading("the robot's x axis points up or down by it");
  CheckedHeading heading;
  heading.stamp = toNanoseconds(message.header.stamp);
  heading.yaw = pose.pose.yaw;
  return heading;
}

}  // namespace place_memory::node
