#include "core/memory/link_pose.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <utility>

namespace place_memory::core {
namespace {

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// As the doc comment of PlaceLink::covariance states.
constexpr double kLeastShift = 0.05;  // [m]
constexpr double kShiftPerMetre = 0.1;
constexpr double kTurn = 0.1;  // [rad]

}  // namespace

std::array<double, 9> turned(const std::array<double, 9>& covariance, double yaw) {
  RowMajor turn = RowMajor::Identity();
  turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(yaw).toRotationMatrix();
  std::array<double, 9> result{};
  Eigen::Map<RowMajor>(result.data()) =
      turn * Eigen::Map<const RowMajor>(covariance.data()) * turn.transpose();
  return result;
}

PlaceLink seenFromSecond(const PlaceLink& link) {
  PlaceLink seen = link;
  std::swap(seen.first, seen.second);
  std::swap(seen.forward, seen.backward);
  seen.first_from_second = link.first_from_second.inverse();
  const Pose2d& back = seen.first_from_second;
  // How the inverse follows small errors of the pose.
  RowMajor jacobian = RowMajor::Identity();
  jacobian.topLeftCorner<2, 2>() =
      Eigen::Rotation2Dd(-link.first_from_second.yaw).toRotationMatrix();
  jacobian(0, 2) = -back.y;
  jacobian(1, 2) = back.x;
  Eigen::Map<RowMajor>(seen.covariance.data()) =
      jacobian * Eigen::Map<const RowMajor>(link.covariance.data()) * jacobian.transpose();
  return seen;
}

PlaceLink linkTo(PlaceId place, const Pose2d& odom_from_place, const Stand& from, bool located,
                 std::chrono::nanoseconds arrived) {
  PlaceLink link;
  link.first = from.place;
  link.second = place;
  link.forward = {1, 0, arrived, 1.0};
  if (!located) {
    for (const std::size_t at : {0, 4, 8}) link.covariance[at] = kUnknownVariance;
    return link;
  }
  link.first_from_second = from.odom_from_place.inverse() * odom_from_place;
  link.covariance = from.covariance;
  const double way = std::hypot(link.first_from_second.x, link.first_from_second.y);
  const double shift = kLeastShift * kLeastShift + kShiftPerMetre * kShiftPerMetre * way * way;
  link.covariance[0] += shift;
  link.covariance[4] += shift;
  link.covariance[8] += kTurn * kTurn;
  return link;
}

}  // namespace place_memory::core
