#include "core/match/restarts.h"

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr int kFirstStep = 4;
/// Starts of the lattice are nearer to their summits than the expected pose is.
constexpr int kFirstStepFromStart = 2;

/// Of the starts that a look shows so many are evaluated.
constexpr std::size_t kEvaluated = 12;
constexpr std::size_t kSettled = 1;

}  // namespace

void climbOnce(Climber& climber) { climber.climb({0, 0}, 0, kFirstStep); }

Starts chooseStarts(const Climber& climber, const StartLattice& lattice, const LookScores& scores,
                    std::size_t place) {
  std::vector<ScoredStart> seen;
  lattice.bestStarts(scores, place, kEvaluated, seen);
  // Coarse cells told where good starts are; the cells themselves tell which are the best.
  std::array<Alignment, kEvaluated> evaluated;
  for (std::size_t i = 0; i < seen.size(); ++i) evaluated[i] = lattice.start(seen[i].start);
  Alignment* const begin = evaluated.data();
  climber.evaluate(begin, seen.size());
  Starts chosen;
  for (std::size_t i = 0; i < std::min(Starts::kMost, seen.size()); ++i) {
    Alignment* const best =
        std::max_element(begin + i, begin + seen.size(),
                         [](const Alignment& a, const Alignment& b) { return a.score < b.score; });
    std::iter_swap(begin + i, best);
    chosen.add(begin[i]);
  }
  return chosen;
}

std::vector<Alignment> climbFromStarts(Climber& climber, const Starts& starts) {
  climbOnce(climber);
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
