#include "restarts.h"

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr int kFirstStep = 4;
/// Starts of the lattice are nearer to their summits than the expected pose is.
constexpr int kFirstStepFromStart = 2;

/// Measured on simulated places: more finds no better alignments.
constexpr std::size_t kStarts = 16;
constexpr std::size_t kClimbs = 4;  ///< from the best of these
constexpr std::size_t kSettled = 4;

}  // namespace

void climbOnce(Climber& climber) { climber.climb({0, 0}, 0, kFirstStep); }

std::vector<Alignment> climbFromStarts(Climber& climber, const StartLattice& lattice,
                                       const std::vector<BlockScores>& scores, std::size_t place) {
  climbOnce(climber);
  // Coarse cells told where good starts are; the cells themselves tell which are the best.
  std::vector<Alignment> starts = lattice.bestStarts(scores, place, kStarts);
  for (Alignment& start : starts) start = climber.evaluate(start.shift, start.turn);
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Alignment& a, const Alignment& b) { return a.score > b.score; });
  if (starts.size() > kClimbs) starts.resize(kClimbs);
  for (const Alignment& start : starts) {
    climber.climb(start.shift, start.turn, kFirstStepFromStart);
  }
  return climber.summits();
}

Alignment settle(Climber& climber, const std::vector<Alignment>& summits) {
  for (std::size_t i = 0; i < std::min(kSettled, summits.size()); ++i) climber.settle(summits[i]);
  return climber.summits().front();
}

}  // namespace place_memory::core
