#ifndef PLACE_MEMORY_CORE_PLACE_ID_H
#define PLACE_MEMORY_CORE_PLACE_ID_H

#include <cstdint>

namespace place_memory::core {

/// Never given twice by one store, even after its place was removed.
using PlaceId = std::int64_t;
constexpr PlaceId kNoPlace = 0;

/// Counts the stretches of time in which the robot knew how it had moved from one scan to the next.
/// The places of one session lie in one frame. How the frames of two sessions lie to each other is
/// not known until a place of the one is recognized during the other: they are joined then, and are
/// one session from there on.
using SessionId = std::int64_t;
constexpr SessionId kNoSession = 0;
constexpr SessionId kFirstSession = 1;

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_ID_H
