#include "place_memory/core/pose_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "climber.h"

namespace place_memory::core {
namespace {

/// Steps. Between smooth walls the truth may lie several cells from the summit; with less than this
/// the covariance of such poses is too small.
constexpr int kShiftReach = 4;
constexpr int kTurnReach = 3;

/// Transforms of the window, and how far from an alignment they are.
struct Nearby {
  std::vector<Alignment> alignments;
  std::vector<Eigen::Vector3d> steps;  ///< columns, rows, heading steps
};

Nearby transformsNear(const Alignment& best, const SearchWindow& window) {
  Nearby nearby;
  for (int turn = -kTurnReach; turn <= kTurnReach; ++turn) {
    const int at_turn = window.wrapped(best.turn + turn);
    if (std::abs(at_turn) > window.turns) continue;
    for (int rows = -kShiftReach; rows <= kShiftReach; ++rows) {
      for (int columns = -kShiftReach; columns <= kShiftReach; ++columns) {
        const CellShift shift{best.shift.columns + columns, best.shift.rows + rows};
        if (std::max(std::abs(shift.columns), std::abs(shift.rows)) > window.cells) continue;
        nearby.alignments.push_back({shift, at_turn});
        nearby.steps.emplace_back(columns, rows, turn);
      }
    }
  }
  return nearby;
}

}  // namespace

PoseEstimate estimatePose(const QueryPlanes& query, const CellPlanes& learned,
                          const LatticeMetric& metric, const SearchWindow& window,
                          const Alignment& best, double cell_size, double sharpness) {
  const Eigen::Vector3d step(cell_size, cell_size, kHeadingStep);
  const Nearby nearby = transformsNear(best, window);
  std::vector<Alignment> at = nearby.alignments;
  at.push_back(best);
  Climber(query, learned, metric, window).evaluate(at.data(), at.size());
  double all = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < nearby.steps.size(); ++i) {
    const double lead = at.back().score - at[i].score;
    const double weight = std::exp(-std::max(sharpness * lead, 0.0));
    const Eigen::Vector3d offset = nearby.steps[i].cwiseProduct(step);
    all += weight;
    mean += weight * offset;
    second += weight * offset * offset.transpose();
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
