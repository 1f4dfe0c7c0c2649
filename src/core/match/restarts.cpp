#include "core/match/restarts.h"

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr int kFirstStep = 4;
/// Seeds of the grid are nearer to their summits than the expected pose is.
constexpr int kFirstStepFromSeed = 2;

/// Of the seeds that score most over coarse cells so many are evaluated.
constexpr std::size_t kEvaluated = 12;
constexpr std::size_t kRefined = 1;

}  // namespace

void climbOnce(Climber& climber) { climber.climb({0, 0}, 0, kFirstStep); }

Seeds chooseSeeds(const Climber& climber, const SeedGrid& grid, const SeedScores& scores,
                  std::size_t place) {
  std::vector<ScoredSeed> foremost;
  grid.bestSeeds(scores, place, kEvaluated, foremost);
  // Coarse cells told where good seeds are; the cells themselves tell which are the best.
  std::array<Alignment, kEvaluated> evaluated;
  for (std::size_t i = 0; i < foremost.size(); ++i) evaluated[i] = grid.seed(foremost[i].seed);
  Alignment* const begin = evaluated.data();
  climber.evaluate(begin, foremost.size());
  Seeds chosen;
  for (std::size_t i = 0; i < std::min(Seeds::kMost, foremost.size()); ++i) {
    Alignment* const best =
        std::max_element(begin + i, begin + foremost.size(),
                         [](const Alignment& a, const Alignment& b) { return a.score < b.score; });
    std::iter_swap(begin + i, best);
    chosen.add(begin[i]);
  }
  return chosen;
}

std::vector<Alignment> climbFromSeeds(Climber& climber, const Seeds& seeds) {
  climbOnce(climber);
  for (const Alignment& seed : seeds) {
    climber.climb(seed.shift, seed.rotation, kFirstStepFromSeed);
  }
  return climber.summits();
}

Alignment refine(Climber& climber, const std::vector<Alignment>& summits) {
  for (std::size_t i = 0; i < std::min(kRefined, summits.size()); ++i) climber.refine(summits[i]);
  return climber.summits().front();
}

}  // namespace place_memory::core
