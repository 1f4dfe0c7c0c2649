#ifndef PLACE_MEMORY_CORE_MAP_PLACE_LABEL_H
#define PLACE_MEMORY_CORE_MAP_PLACE_LABEL_H

#include <cstddef>
#include <string_view>

namespace place_memory::core {

constexpr std::size_t kMaxLabelBytes = 255;

/// Whether a place may be called so: 1 to kMaxLabelBytes bytes of UTF-8 without control characters,
/// not all of them blanks.
bool isValidLabel(std::string_view label);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_PLACE_LABEL_H
