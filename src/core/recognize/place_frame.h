#ifndef PLACE_MEMORY_CORE_RECOGNIZE_PLACE_FRAME_H
#define PLACE_MEMORY_CORE_RECOGNIZE_PLACE_FRAME_H

#include <functional>
#include <optional>
#include <vector>

#include "place_memory/core/place.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Where a place lies.
struct PlaceFrame {
  Pose2d map_from_place;  ///< in the frame of its session
  SessionId session = kFirstSession;
};

/// The frames of these places, in their order, as they are at one moment; nothing where one of the
/// places is gone. Called from the recognizer's caller's thread.
using LookUpFrames =
    std::function<std::optional<std::vector<PlaceFrame>>(const std::vector<PlaceId>&)>;

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_PLACE_FRAME_H
