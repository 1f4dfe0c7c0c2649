#ifndef PLACE_MEMORY_CORE_STORE_PLACE_IDS_H
#define PLACE_MEMORY_CORE_STORE_PLACE_IDS_H

#include <vector>

#include "place_memory/core/map_change.h"

namespace place_memory::core {

/// In the order of the places.
std::vector<PlaceId> idsOf(const std::vector<Place>& places);

/// What becomes of the ids of all places, which rise, by a change.
void follow(const MapChange& change, std::vector<PlaceId>& ids);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_PLACE_IDS_H
