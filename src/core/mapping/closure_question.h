#ifndef PLACE_MEMORY_CORE_MAPPING_CLOSURE_QUESTION_H
#define PLACE_MEMORY_CORE_MAPPING_CLOSURE_QUESTION_H

#include <cstddef>
#include <string>

#include "place_memory/core/place_id.h"

namespace place_memory::core {

/// A loop that may close, or where a robot that was carried or starts anew may be: what a person
/// may know.
struct ClosureQuestion {
  PlaceId place = kNoPlace;  ///< where the newest of the scans that agree has the robot
  std::size_t scans = 0;     ///< that agree
  std::string evidence;      ///< in words
};

/// What became of a person's word.
enum class ClosureWord {
  kDone,
  kNoQuestion,  ///< nothing says that the robot is there
  kRefused      ///< the map speaks against it: older ties would suffer, or none would be left
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_CLOSURE_QUESTION_H
