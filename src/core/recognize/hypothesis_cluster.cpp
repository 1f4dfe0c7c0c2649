#include "core/recognize/hypothesis_cluster.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

bool agree(const std::optional<Pose2d>& a, const std::optional<Pose2d>& b, double cell_size) {
  return a && b && std::hypot(a->x - b->x, a->y - b->y) <= kClusterRadius * cell_size &&
         std::abs(wrapAngle(a->yaw - b->yaw)) <= kClusterAngle;
}

}  // namespace

HypothesisCluster clusterHypotheses(const std::vector<PoseHypothesis>& hypotheses,
                                    double cell_size) {
  HypothesisCluster cluster;
  const PoseHypothesis& best = hypotheses.front();
  double contradicting = 0.0, sum = 0.0;
  const std::size_t count = std::min(hypotheses.size(), kMostHypotheses);
  for (std::size_t i = 1; i < count; ++i) {
    const PoseHypothesis& hypothesis = hypotheses[i];
    if (hypothesis.session != best.session) continue;
    if (agree(hypothesis.map_from_scan, best.map_from_scan, cell_size)) {
      if (hypothesis.shift < hypotheses[cluster.chosen].shift) cluster.chosen = i;
      continue;
    }
    if (contradicting == 0.0) cluster.margin = best.score - hypothesis.score;
    contradicting += 1.0;
    sum += hypothesis.score;
  }
  if (contradicting > 0.0) {
    cluster.mean_margin = best.score - sum / contradicting;
  } else {
    cluster.unopposed = std::max(best.score, 0.0);
  }
  return cluster;
}

}  // namespace place_memory::core
