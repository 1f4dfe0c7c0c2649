#include "place_memory/core/pose_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "climber.h"

namespace place_memory::core {
namespace {

constexpr int kReach = 2;  ///< steps

}  // namespace

PoseEstimate estimatePose(const QueryPlanes& query, const CellPlanes& learned,
                          const LatticeMetric& metric, const SearchWindow& window,
                          const Alignment& best, double cell_size, double sharpness) {
  const Climber scorer(query, learned, metric, window);
  const double best_score = scorer.evaluate(best.shift, best.turn).score;
  double all = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  const Eigen::Vector3d step(cell_size, cell_size, kHeadingStep);
  for (int turn = -kReach; turn <= kReach; ++turn) {
    const int at_turn = window.wrapped(best.turn + turn);
    if (std::abs(at_turn) > window.turns) continue;
    for (int rows = -kReach; rows <= kReach; ++rows) {
      for (int columns = -kReach; columns <= kReach; ++columns) {
        const CellShift shift{best.shift.columns + columns, best.shift.rows + rows};
        if (std::max(std::abs(shift.columns), std::abs(shift.rows)) > window.cells) continue;
        const double score = scorer.evaluate(shift, at_turn).score;
        const double weight = std::exp(std::min(sharpness * (score - best_score), 0.0));
        const Eigen::Vector3d offset = Eigen::Vector3d(columns, rows, turn).cwiseProduct(step);
        all += weight;
        mean += weight * offset;
        second += weight * offset * offset.transpose();
      }
    }
  }
  mean /= all;
  PoseEstimate estimate;
  estimate.place_from_scan = {best.shift.columns * cell_size + mean.x(),
                              best.shift.rows * cell_size + mean.y(),
                              wrapAngle(best.turn * kHeadingStep + mean.z())};
  // Within a step every transform is as likely: a uniform distribution's variance.
  const Eigen::Vector3d within = step.cwiseAbs2() / 12.0;
  estimate.covariance = second / all - mean * mean.transpose();
  estimate.covariance.diagonal() += within;
  return estimate;
}

}  // namespace place_memory::core
