#ifndef PLACE_MEMORY_CORE_MATCH_RESTARTS_H
#define PLACE_MEMORY_CORE_MATCH_RESTARTS_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/match/climber.h"
#include "core/match/start_lattice.h"

namespace place_memory::core {

/// The paper's hill climbing: one climb from the expected pose (paper 4).
void climbOnce(Climber& climber);

/// Where one place is climbed for from, best first.
class Starts {
 public:
  static constexpr std::size_t kMost = 3;  ///< measured: more find no better alignments

  void add(const Alignment& start) { starts_[size_++] = start; }
  const Alignment& front() const { return starts_.front(); }
  const Alignment* begin() const { return starts_.data(); }
  const Alignment* end() const { return starts_.data() + size_; }

 private:
  std::array<Alignment, kMost> starts_;
  std::size_t size_ = 0;
};

/// Chooses starts by what they score in truth, of those that scored most in a look at the place; at
/// least one.
Starts chooseStarts(const Climber& climber, const StartLattice& lattice, const LookScores& scores,
                    std::size_t place);

/// Hill climbing with restarts: from the expected pose and from the starts (paper 4, last lines).
/// Returns the summits, best first.
std::vector<Alignment> climbFromStarts(Climber& climber, const Starts& starts);

/// The best alignment near these summits, best first.
Alignment settle(Climber& climber, const std::vector<Alignment>& summits);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_RESTARTS_H
