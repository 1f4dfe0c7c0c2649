#ifndef PLACE_MEMORY_CORE_PLACE_ID_H
#define PLACE_MEMORY_CORE_PLACE_ID_H

#include <cstdint>

namespace place_memory::core {

/// Never given twice by one store, even after its place was removed.
using PlaceId = std::int64_t;
constexpr PlaceId kNoPlace = 0;

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_ID_H
