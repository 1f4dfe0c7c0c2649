#include "core/mapping/odometry_reach.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;
// Wider than the noise that the map is relaxed with: a wheel may slip.
constexpr double kPositionNoise = 0.05;      // by the root of the way in metres [m]
constexpr double kYawNoise = 2.5 * kDegree;  // likewise
constexpr double kScaleSigma = 0.05;
constexpr double kTieNoise = 0.05;  // [m]
constexpr double kTieTurnNoise = 1.5 * kDegree;
constexpr double kCompassSigma = 20.0 * kDegree;
// Of the match that is compared.
constexpr double kPositionFloor = 0.25;  // [m]
constexpr double kYawFloor = 5.0 * kDegree;

/// How a small turn at a node moves and turns `end`.
Eigen::Vector3d leverOf(const Pose2d& node, const Pose2d& end) {
  return {node.y - end.y, end.x - node.x, 1.0};
}

}  // namespace

Eigen::Matrix3d wayCovariance(const ScanGraph& graph, const std::vector<NodeIndex>& way,
                              bool compass) {
  const Pose2d& end = graph.node(way.front()).pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Vector3d bend = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
  double farthest = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const ScanNode& from = graph.node(way[i - 1]);
    const ScanNode& to = graph.node(way[i]);
    const Eigen::Vector3d lever = leverOf(to.pose, end);
    farthest = std::max(farthest, lever.head<2>().norm());
    const bool back = from.before == way[i], on = to.before == way[i - 1];
    const ScanNode& moved = back ? from : to;
    const double length = back || on ? moved.motion_way : 0.0;
    const double yaw = back || on ? kYawNoise * std::sqrt(length) : kTieTurnNoise;
    const double position = back || on ? kPositionNoise * std::sqrt(length) : kTieNoise;
    covariance += yaw * yaw * lever * lever.transpose();
    covariance.diagonal().head<2>().array() += position * position;
    if (!back && !on) continue;
    bend += (back ? length : -length) * lever;
    turn += (back ? moved.motion_turn : -moved.motion_turn) * lever;
  }
  const OdometryErrors& sigmas = graph.errorSigmas();
  covariance += sigmas.bend * sigmas.bend * bend * bend.transpose();
  covariance += sigmas.turn_factor * sigmas.turn_factor * turn * turn.transpose();
  if (compass && covariance(2, 2) > kCompassSigma * kCompassSigma) {
    covariance *= kCompassSigma * kCompassSigma / covariance(2, 2);
  }
  const Pose2d& begin = graph.node(way.back()).pose;
  const Eigen::Vector3d net(end.x - begin.x, end.y - begin.y, 0.0);
  covariance += kScaleSigma * kScaleSigma * net * net.transpose();
  // A large turn is no straight shift.
  const double curved = 0.5 * std::min(covariance(2, 2), kPi) * farthest;
  covariance.diagonal().head<2>().array() += curved * curved + kPositionFloor * kPositionFloor;
  covariance(2, 2) += kYawFloor * kYawFloor;
  return covariance;
}

double sigmasOff(const ScanGraph& graph, const std::vector<NodeIndex>& way, bool compass,
                 const Pose2d& pose) {
  const Pose2d& thought = graph.node(way.front()).pose;
  const Eigen::Vector3d off(pose.x - thought.x, pose.y - thought.y,
                            wrapAngle(pose.yaw - thought.yaw));
  return std::sqrt(off.dot(wayCovariance(graph, way, compass).inverse() * off));
}

}  // namespace place_memory::core
