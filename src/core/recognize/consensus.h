#ifndef PLACE_MEMORY_CORE_RECOGNIZE_CONSENSUS_H
#define PLACE_MEMORY_CORE_RECOGNIZE_CONSENSUS_H

#include <cstddef>
#include <optional>
#include <vector>

#include "core/recognize/place_frame.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Where one place's alignment puts the robot.
struct Opinion {
  double score = 0.0;
  double shift = 0.0;  ///< of the alignment: how far from the place the robot would stand [m]
  /// The pose of the scan frame that follows; none: where the place lies is not known, and it
  /// contradicts every other.
  std::optional<Pose2d> map_from_scan;
  SessionId session = 1;  ///< in whose frame that is
};

/// So many opinions are heard at the most.
constexpr std::size_t kHeard = 10;

/// What the opinions, best score first, come to.
struct Consensus {
  std::size_t chosen = 0;
  /// What the best scores above the best of those that contradict it, and above the mean of them;
  /// both at least 0, and 0 where none contradicts it.
  double lead = 0.0;
  double prominence = 0.0;
  double uncontested =
      0.0;  ///< what the best scores, at least 0, where none contradicts it; else 0
};

/// Neighbouring places see the same walls, so several may align rightly with one scan. Those that
/// put the robot at the same spot as the best one do not contradict it, and of them the place is
/// chosen that the robot stands nearest to (paper 7: a place is the region about its location). The
/// best kHeard are heard, and of them those of the best one's session: where the others put the
/// robot tells nothing of where it puts it. `opinions` is not empty.
Consensus findConsensus(const std::vector<Opinion>& opinions, double cell_size);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_CONSENSUS_H
