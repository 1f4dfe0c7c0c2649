#ifndef PLACE_MEMORY_CORE_ROUTE_NO_ROUTE_H
#define PLACE_MEMORY_CORE_ROUTE_NO_ROUTE_H

#include <string>

#include "core/route/route_graph.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/routes.h"

namespace place_memory::core {

/// Why no route leads from one place of the map to another, in a sentence. Looks at all of the map.
std::string whyNoRoute(const PlaceMap& map, const RouteGraph& graph, PlaceId from, PlaceId to);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ROUTE_NO_ROUTE_H
