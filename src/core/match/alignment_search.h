#ifndef PLACE_MEMORY_CORE_MATCH_ALIGNMENT_SEARCH_H
#define PLACE_MEMORY_CORE_MATCH_ALIGNMENT_SEARCH_H

#include "core/match/alignment.h"
#include "core/match/lattice.h"
#include "core/match/query_planes.h"
#include "place_memory/core/search_method.h"

namespace place_memory::core {

/// What an alignment scores.
double scoreAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
               CellShift shift, int rotation);

/// The best alignment of the recognition grid with one learned grid that the method finds.
Alignment findAlignment(const QueryPlanes& query, const CellPlanes& learned,
                        const LatticeMetric& metric, const SearchWindow& window,
                        SearchMethod method);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_ALIGNMENT_SEARCH_H
