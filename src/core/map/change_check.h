#ifndef PLACE_MEMORY_CORE_MAP_CHANGE_CHECK_H
#define PLACE_MEMORY_CORE_MAP_CHANGE_CHECK_H

#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// Throws std::invalid_argument, saying why, where the change does not fit the map: see
/// PlaceMap::check(). Takes as long as the change is, however large the map.
void checkChange(const PlaceMap& map, const MapChange& change);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_CHANGE_CHECK_H
