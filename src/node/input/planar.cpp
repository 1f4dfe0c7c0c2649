#include "node/input/planar.h"

#include <cmath>

namespace place_memory::node {

PlanarPose planar(const geometry_msgs::Transform& transform) {
  const geometry_msgs::Quaternion& q = transform.rotation;
  const double norm2 = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  const double axis_x = (q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z) / norm2;
  const double axis_y = 2.0 * (q.x * q.y + q.w * q.z) / norm2;
  PlanarPose result;
  result.pose = {transform.translation.x, transform.translation.y, std::atan2(axis_y, axis_x)};
  result.upside_down = q.w * q.w - q.x * q.x - q.y * q.y + q.z * q.z < 0.0;
  result.level = std::fmin(1.0, std::hypot(axis_x, axis_y));
  return result;
}

}  // namespace place_memory::node
