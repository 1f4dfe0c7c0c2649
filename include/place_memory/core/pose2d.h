#ifndef PLACE_MEMORY_CORE_POSE2D_H
#define PLACE_MEMORY_CORE_POSE2D_H

#include <cmath>

namespace place_memory::core {

constexpr double kPi = 3.14159265358979323846;

/// The same angle in [-pi, pi) [rad]. NaN and infinities give NaN.
inline double wrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * kPi);  // rounds to nothing outside [-pi, pi]
  return wrapped < kPi ? wrapped : wrapped - 2.0 * kPi;
}

/// A planar rigid transform, or the pose of one frame in another (REP 103: x forward or east, y
/// left or north, yaw counter-clockwise).
struct Pose2d {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad], any turn; wrapAngle() where a range matters

  /// The pose `local`, given in this frame, in the frame in which this one is given.
  Pose2d operator*(const Pose2d& local) const {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {x + c * local.x - s * local.y, y + s * local.x + c * local.y,
            wrapAngle(yaw + local.yaw)};
  }

  Pose2d inverse() const {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {-c * x - s * y, s * x - c * y, wrapAngle(-yaw)};
  }

  bool operator==(const Pose2d& other) const {
    return x == other.x && y == other.y && yaw == other.yaw;
  }
  bool operator!=(const Pose2d& other) const { return !(*this == other); }

  bool isFinite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(yaw); }
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_POSE2D_H
