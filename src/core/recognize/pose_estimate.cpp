#include "core/recognize/pose_estimate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/match/climber.h"

namespace place_memory::core {
namespace {

struct Reach {
  int shift;     ///< [cells]
  int rotation;  ///< [heading steps]

  bool covers(int columns, int rows, int rotations) const {
    return std::max(std::abs(columns), std::abs(rows)) <= shift && std::abs(rotations) <= rotation;
  }
};
constexpr Reach kNowhere{-1, -1};
constexpr Reach kNear{2, 2};
/// Between smooth walls the truth may lie several cells from the summit; with less than this the
/// covariance of such poses is too small.
constexpr Reach kFar{4, 3};
/// Where no transform at the rim of what is near weighs so much, what lies beyond hardly counts,
/// and is left out: most alignments are sharp.
constexpr double kLittle = 0.05;

/// A transform of the window, how far from an alignment it is, and what it weighs.
struct Nearby {
  Eigen::Vector3d steps;  ///< columns, rows, heading steps
  double weight;
};

/// Adds what `to` covers and `from` does not. `score` is that of the alignment, by the metric.
void addTransforms(const Climber& climber, const SearchWindow& window, const Alignment& best,
                   double score, double sharpness, const Reach& from, const Reach& to,
                   std::vector<Nearby>& nearby) {
  std::vector<Alignment> at;
  const std::size_t before = nearby.size();
  for (int rotation = -to.rotation; rotation <= to.rotation; ++rotation) {
    const int at_rotation = window.wrapped(best.rotation + rotation);
    if (std::abs(at_rotation) > window.rotations) continue;
    for (int rows = -to.shift; rows <= to.shift; ++rows) {
      for (int columns = -to.shift; columns <= to.shift; ++columns) {
        if (from.covers(columns, rows, rotation)) continue;
        const CellShift shift{best.shift.columns + columns, best.shift.rows + rows};
        if (std::max(std::abs(shift.columns), std::abs(shift.rows)) > window.cells) continue;
        at.push_back({shift, at_rotation});
        nearby.push_back({Eigen::Vector3d(columns, rows, rotation), 0.0});
      }
    }
  }
  climber.evaluate(at.data(), at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    nearby[before + i].weight = std::exp(-std::max(sharpness * (score - at[i].score), 0.0));
  }
}

bool fadesOut(const std::vector<Nearby>& nearby) {
  return std::none_of(nearby.begin(), nearby.end(), [](const Nearby& transform) {
    const Eigen::Vector3d steps = transform.steps.cwiseAbs();
    const bool at_rim =
        std::max(steps.x(), steps.y()) >= kNear.shift || steps.z() >= kNear.rotation;
    return at_rim && transform.weight >= kLittle;
  });
}

}  // namespace

PoseEstimate estimatePose(const QueryPlanes& query, const CellPlanes& learned,
                          const LatticeMetric& metric, const SearchWindow& window,
                          const Alignment& best, double cell_size, double sharpness) {
  const Eigen::Vector3d step(cell_size, cell_size, kHeadingStep);
  const Climber climber(query, learned, metric, window);
  const double score = climber.evaluate(best.shift, best.rotation).score;
  std::vector<Nearby> nearby;
  addTransforms(climber, window, best, score, sharpness, kNowhere, kNear, nearby);
  if (!fadesOut(nearby)) {
    addTransforms(climber, window, best, score, sharpness, kNear, kFar, nearby);
  }
  double all = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Nearby& transform : nearby) {
    const Eigen::Vector3d offset = transform.steps.cwiseProduct(step);
    all += transform.weight;
    mean += transform.weight * offset;
    second += transform.weight * offset * offset.transpose();
  }
  mean /= all;
  PoseEstimate estimate;
  estimate.place_from_scan = {best.shift.columns * cell_size + mean.x(),
                              best.shift.rows * cell_size + mean.y(),
                              wrapAngle(best.rotation * kHeadingStep + mean.z())};
  // Within a step every transform is as likely: a uniform distribution's variance.
  const Eigen::Vector3d within = step.cwiseAbs2() / 12.0;
  estimate.covariance = second / all - mean * mean.transpose();
  estimate.covariance.diagonal() += within;
  return estimate;
}

RobotPose robotPose(const Pose2d& map_from_place, const PoseEstimate& estimate,
                    const Pose2d& robot_in_scan) {
  const Pose2d place_from_robot = estimate.place_from_scan * robot_in_scan;
  Eigen::Matrix3d jacobian =
      Eigen::Matrix3d::Identity();  // of place_from_robot, by place_from_scan
  jacobian(0, 2) = estimate.place_from_scan.y - place_from_robot.y;
  jacobian(1, 2) = place_from_robot.x - estimate.place_from_scan.x;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // from the place's axes to the map's
  rotation.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(map_from_place.yaw).toRotationMatrix();
  const Eigen::Matrix3d in_place = jacobian * estimate.covariance * jacobian.transpose();
  return {map_from_place * estimate.place_from_scan * robot_in_scan,
          rotation * in_place * rotation.transpose()};
}

}  // namespace place_memory::core
