#include "core/recognize/consensus.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kSameSpot = 3.5;                    ///< [cells]
constexpr double kSameHeading = 25.0 * kPi / 180.0;  ///< [rad]

bool agree(const std::optional<Pose2d>& a, const std::optional<Pose2d>& b, double cell_size) {
  return a && b && std::hypot(a->x - b->x, a->y - b->y) <= kSameSpot * cell_size &&
         std::abs(wrapAngle(a->yaw - b->yaw)) <= kSameHeading;
}

}  // namespace

Consensus findConsensus(const std::vector<Opinion>& opinions, double cell_size) {
  Consensus consensus;
  const Opinion& best = opinions.front();
  double contradicting = 0.0, sum = 0.0;
  const std::size_t heard = std::min(opinions.size(), kHeard);
  for (std::size_t i = 1; i < heard; ++i) {
    const Opinion& opinion = opinions[i];
    if (opinion.session != best.session) continue;
    if (agree(opinion.map_from_scan, best.map_from_scan, cell_size)) {
      if (opinion.shift < opinions[consensus.chosen].shift) consensus.chosen = i;
      continue;
    }
    if (contradicting == 0.0) consensus.lead = best.score - opinion.score;
    contradicting += 1.0;
    sum += opinion.score;
  }
  if (contradicting > 0.0) {
    consensus.prominence = best.score - sum / contradicting;
  } else {
    consensus.uncontested = std::max(best.score, 0.0);
  }
  return consensus;
}

}  // namespace place_memory::core
