#ifndef PLACE_MEMORY_CORE_RESTARTS_H
#define PLACE_MEMORY_CORE_RESTARTS_H

#include <vector>

#include "climber.h"
#include "start_lattice.h"

namespace place_memory::core {

/// The paper's hill climbing: one climb from the expected pose (paper 4).
void climbOnce(Climber& climber);

/// Hill climbing with restarts: from the expected pose and from the best starts of the lattice,
/// where the place scored `scores` in a close look (paper 4, last lines). Returns the summits, best
/// first.
std::vector<Alignment> climbFromStarts(Climber& climber, const StartLattice& lattice,
                                       const std::vector<BlockScores>& scores, std::size_t place);

/// The best alignment near these summits, best first.
Alignment settle(Climber& climber, const std::vector<Alignment>& summits);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RESTARTS_H
