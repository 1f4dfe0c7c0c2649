#ifndef PLACE_MEMORY_CORE_MATCH_ALIGNMENT_H
#define PLACE_MEMORY_CORE_MATCH_ALIGNMENT_H

#include "core/grid/cell_shift.h"

namespace place_memory::core {

/// A transform of the recognition grid on the search's lattice, and what it scores.
struct Alignment {
  CellShift shift;
  int rotation = 0;  ///< heading step of the QueryPlanes
  double score = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_ALIGNMENT_H
