#ifndef PLACE_MEMORY_NODE_MAP_MAP_MESSAGES_H
#define PLACE_MEMORY_NODE_MAP_MAP_MESSAGES_H

#include <place_memory/MapChange.h>
#include <place_memory/Place.h>
#include <place_memory/PlaceGraph.h>

#include <string>

#include "place_memory/core/map_change.h"
#include "place_memory/core/place.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::node {

Place toMessage(const core::Place& place);
PlaceLink toMessage(const core::PlaceLink& link);

/// `map_frame`: in which places lie.
PlaceGraph toMessage(const core::MapSnapshot& map, const std::string& map_frame);

/// What the edits come to, in the order in which MapChange.msg has it done: where two edits of one
/// place or link follow each other, the outcome of both.
MapChange toMessage(const core::MapChange& change, const std::string& map_frame);

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_MAP_MESSAGES_H
