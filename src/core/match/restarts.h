#ifndef PLACE_MEMORY_CORE_MATCH_RESTARTS_H
#define PLACE_MEMORY_CORE_MATCH_RESTARTS_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/match/climber.h"
#include "core/match/seed_grid.h"

namespace place_memory::core {

/// The paper's hill climbing: one climb from the expected pose (paper 4).
void climbOnce(Climber& climber);

/// Where one place is climbed for from, best first.
class Seeds {
 public:
  static constexpr std::size_t kMost = 3;  ///< measured: more find no better alignments

  void add(const Alignment& seed) { seeds_[size_++] = seed; }
  const Alignment& front() const { return seeds_.front(); }
  const Alignment* begin() const { return seeds_.data(); }
  const Alignment* end() const { return seeds_.data() + size_; }

 private:
  std::array<Alignment, kMost> seeds_;
  std::size_t size_ = 0;
};

/// Chooses seeds by what they score cell by cell, of those that scored most over coarse cells; at
/// least one. `place` is a slot of the scored block.
Seeds chooseSeeds(const Climber& climber, const SeedGrid& grid, const SeedScores& scores,
                  std::size_t place);

/// Random-restart hill climbing (Russell and Norvig, Artificial Intelligence), with seeds in place
/// of random starts: climbs from the expected pose and from the seeds (paper 4, last lines).
/// Returns the summits, best first.
std::vector<Alignment> climbFromSeeds(Climber& climber, const Seeds& seeds);

/// The best alignment near these summits, best first.
Alignment refine(Climber& climber, const std::vector<Alignment>& summits);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_RESTARTS_H
