#ifndef PLACE_MEMORY_CORE_MAPPING_MAPPER_EVENT_H
#define PLACE_MEMORY_CORE_MAPPING_MAPPER_EVENT_H

#include <chrono>
#include <vector>

#include "place_memory/core/place_id.h"

namespace place_memory::core {

/// What became of the map, or of where the robot is, beyond single scans.
struct MapperEvent {
  enum class Kind {
    kClosed,     ///< a loop
    kJoined,     ///< the robot's session with the map
    kRefused,    ///< a closure or a join that the map speaks against
    kTakenBack,  ///< likewise, one that had been made
    kLost        ///< the robot is not where it was thought to be: its session is apart from here on
  };

  Kind kind = Kind::kClosed;
  std::chrono::nanoseconds stamp{0};  ///< of the newest scan
  std::vector<PlaceId> witnesses;     ///< places that scans agreed with, each once, by rising id
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_MAPPER_EVENT_H
