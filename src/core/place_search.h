#ifndef PLACE_MEMORY_CORE_PLACE_SEARCH_H
#define PLACE_MEMORY_CORE_PLACE_SEARCH_H

#include <functional>
#include <vector>

#include "place_memory/core/alignment_search.h"
#include "place_memory/core/place_index.h"

namespace place_memory::core {

/// A place at the best alignment that was found for it.
struct PlaceAlignment {
  const PlaceIndex::Entry* entry;
  Alignment alignment;
};

/// Aligns the recognition grid with every place, and returns them by falling score; places that
/// score the same, by rising id. `cancelled`, where given, is polled between blocks of places; once
/// it returns true the call throws std::runtime_error.
std::vector<PlaceAlignment> searchPlaces(const QueryPlanes& query, const PlaceIndex& places,
                                         const LatticeMetric& metric, const SearchWindow& window,
                                         SearchMethod method,
                                         const std::function<bool()>& cancelled);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_SEARCH_H
