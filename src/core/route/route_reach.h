#ifndef PLACE_MEMORY_CORE_ROUTE_ROUTE_REACH_H
#define PLACE_MEMORY_CORE_ROUTE_ROUTE_REACH_H

#include <vector>

#include "core/route/route_graph.h"

namespace place_memory::core {

/// A place that a way leads to.
struct ReachedPlace {
  PlaceId place = kNoPlace;
  PlaceId before = kNoPlace;  ///< the last one of the way before it; kNoPlace: the way begins here
  double time = 0.0;          ///< expected [s]
};

/// The places to which a way of no more than `most_time` [s] leads, the quickest to reach first;
/// `from` is the first of them. Empty where there is no such place. (Dijkstra 1959.)
std::vector<ReachedPlace> reachedFrom(const RouteGraph& graph, PlaceId from, double most_time);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ROUTE_ROUTE_REACH_H
