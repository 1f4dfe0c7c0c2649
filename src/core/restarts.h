#ifndef PLACE_MEMORY_CORE_RESTARTS_H
#define PLACE_MEMORY_CORE_RESTARTS_H

#include <vector>

#include "climber.h"
#include "start_lattice.h"

namespace place_memory::core {

/// First step of a climb from the expected pose (paper 4).
constexpr int kFirstStep = 4;

/// Hill climbing from the expected pose and from the peaks of the lattice, where the place scored
/// `scores` in a close look (paper 4, last lines).
Alignment climbFromPeaks(const Climber& climber, const StartLattice& lattice,
                         const std::vector<BlockScores>& scores, std::size_t place);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RESTARTS_H
