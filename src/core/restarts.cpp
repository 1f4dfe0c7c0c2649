#include "restarts.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kMostStarts = 8;
/// Peaks are nearer to their summits than the expected pose is.
constexpr int kFirstStepFromPeak = 2;

}  // namespace

Alignment climbFromPeaks(const Climber& climber, const StartLattice& lattice,
                         const std::vector<BlockScores>& scores, std::size_t place) {
  Alignment best = climber.climb(climber.evaluate({0, 0}, 0), kFirstStep);
  for (const std::size_t i : lattice.peaks(scores, place, kMostStarts)) {
    const Alignment start = lattice.start(i);
    const Alignment found =
        climber.climb(climber.evaluate(start.shift, start.turn), kFirstStepFromPeak);
    if (found.score > best.score) best = found;
  }
  return climber.settle(best);
}

}  // namespace place_memory::core
