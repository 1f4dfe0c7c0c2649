#ifndef PLACE_MEMORY_CORE_MEMORY_FRAME_CONSENSUS_H
#define PLACE_MEMORY_CORE_MEMORY_FRAME_CONSENSUS_H

#include <cstddef>
#include <optional>
#include <vector>

#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// One place that is known in two frames.
struct FramePair {
  SessionId session = kNoSession;  ///< of the frame `into`
  Pose2d into_from_place;
  Pose2d from_from_place;
  PlaceId place = kNoPlace;  ///< in `into`: witnesses are counted by it
  bool sure = false;         ///< that it is the same place is known for certain
};

/// What most pairs say of how the frames lie.
struct FrameConsensus {
  SessionId session = kNoSession;
  Pose2d into_from_from;
};

/// Nothing where fewer than `least` places agree, or not twice as many as agree on anything else.
/// Pairs that are sure count as many as `least`.
std::optional<FrameConsensus> frameConsensus(const std::vector<FramePair>& pairs,
                                             std::size_t least);

/// Whether the pair lies as the consensus has it.
bool agrees(const FrameConsensus& consensus, const FramePair& pair, double way);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_FRAME_CONSENSUS_H
