#ifndef PLACE_MEMORY_CORE_MAP_CHANGE_WORDS_H
#define PLACE_MEMORY_CORE_MAP_CHANGE_WORDS_H

#include <string>
#include <vector>

#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// What the edits are about to do to the map, in words, as: renamed "a" to "b". Empty where all
/// they do is to learn from traversals of links.
std::string editsInWords(const std::vector<MapEdit>& edits, const PlaceMap& before);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_CHANGE_WORDS_H
