#ifndef PLACE_MEMORY_CORE_ALIGNMENT_SEARCH_H
#define PLACE_MEMORY_CORE_ALIGNMENT_SEARCH_H

#include "place_memory/core/lattice.h"
#include "place_memory/core/query_planes.h"
#include "place_memory/core/recognizer_options.h"

namespace place_memory::core {

/// A transform of the recognition grid on the search's lattice, and what it scores.
struct Alignment {
  CellShift shift;
  int turn = 0;  ///< heading step of the QueryPlanes
  double score = 0.0;
};

/// What an alignment scores.
double scoreAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
               CellShift shift, int turn);

/// The best alignment of the recognition grid with one learned grid that the method finds.
Alignment findAlignment(const QueryPlanes& query, const CellPlanes& learned,
                        const LatticeMetric& metric, const SearchWindow& window,
                        SearchMethod method);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ALIGNMENT_SEARCH_H
