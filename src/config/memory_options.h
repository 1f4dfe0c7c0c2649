#ifndef PLACE_MEMORY_CONFIG_MEMORY_OPTIONS_H
#define PLACE_MEMORY_CONFIG_MEMORY_OPTIONS_H

#include "config/parameters.h"
#include "core/mapping/fused_map.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::config {

/// Of the memory that the parameters describe.
core::PlaceMemoryOptions memoryOptions(const Parameters& parameters);

/// Of the building's map that they describe.
core::FusedMapOptions fusedMapOptions(const Parameters& parameters);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_MEMORY_OPTIONS_H
