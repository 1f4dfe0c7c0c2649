#include "place_memory/core/consensus.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr std::size_t kHeard = 12;
constexpr double kSameSpot = 3.5;                    ///< [cells]
constexpr double kSameHeading = 25.0 * kPi / 180.0;  ///< [rad]

bool agree(const Pose2d& a, const Pose2d& b, double cell_size) {
  return std::hypot(a.x - b.x, a.y - b.y) <= kSameSpot * cell_size &&
         std::abs(wrapAngle(a.yaw - b.yaw)) <= kSameHeading;
}

}  // namespace

Consensus findConsensus(const std::vector<Opinion>& opinions, double cell_size) {
  Consensus consensus;
  const Opinion& best = opinions.front();
  const std::size_t heard = std::min(opinions.size(), kHeard);
  for (std::size_t i = 1; i < heard; ++i) {
    if (!agree(opinions[i].map_from_scan, best.map_from_scan, cell_size)) continue;
    if (opinions[i].shift < opinions[consensus.chosen].shift) consensus.chosen = i;
  }
  for (const Opinion& opinion : opinions) {
    if (agree(opinion.map_from_scan, best.map_from_scan, cell_size)) continue;
    consensus.runner_up = std::max(opinion.score, 0.0);
    break;
  }
  return consensus;
}

}  // namespace place_memory::core
