#ifndef PLACE_MEMORY_CORE_FALLOFF_H
#define PLACE_MEMORY_CORE_FALLOFF_H

#include "place_memory/core/alignment_search.h"
#include "place_memory/core/second_look.h"

namespace place_memory::core {

/// Of the learned grid with the recognition grid at the alignment, which lies in the window.
Falloff falloffAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
                  const SearchWindow& window, const Alignment& at);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_FALLOFF_H
