#ifndef PLACE_MEMORY_CORE_MAP_HISTORY_H
#define PLACE_MEMORY_CORE_MAP_HISTORY_H

#include <chrono>
#include <cstdint>
#include <string>

namespace place_memory::core {

/// A change of the map as its history tells of it.
struct PastChange {
  std::uint64_t version = 0;          ///< of the map after it
  std::chrono::nanoseconds stamp{0};  ///< when it was made
  std::string words;                  ///< what it did, as: learned "kitchen"
  bool can_be_undone = true;          ///< what it overwrote was not too much to be kept
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_HISTORY_H
