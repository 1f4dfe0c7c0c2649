#ifndef PLACE_MEMORY_CORE_RECOGNIZE_FALLOFF_H
#define PLACE_MEMORY_CORE_RECOGNIZE_FALLOFF_H

#include "core/match/alignment_search.h"
#include "core/recognize/second_look.h"

namespace place_memory::core {

/// Of the learned grid with the recognition grid at the alignment, which lies in the window.
Falloff falloffAt(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
                  const SearchWindow& window, const Alignment& at);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_FALLOFF_H
