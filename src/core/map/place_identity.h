#ifndef PLACE_MEMORY_CORE_MAP_PLACE_IDENTITY_H
#define PLACE_MEMORY_CORE_MAP_PLACE_IDENTITY_H

#include "place_memory/core/place.h"

namespace place_memory::core {

/// Drawn from the system's source of randomness.
PlaceIdentity makePlaceIdentity();

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_PLACE_IDENTITY_H
