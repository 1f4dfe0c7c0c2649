#ifndef PLACE_MEMORY_NODE_MAP_NEAREST_PLACES_H
#define PLACE_MEMORY_NODE_MAP_NEAREST_PLACES_H

#include <cstddef>
#include <vector>

#include "place_memory/core/place.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::node {

/// Those nearest to a spot of the map frame, `count` at the most, the nearest first.
std::vector<const core::Place*> nearestPlaces(const std::vector<core::Place>& places,
                                              const core::Pose2d& to, std::size_t count);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_NEAREST_PLACES_H
