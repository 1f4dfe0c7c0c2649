#ifndef PLACE_MEMORY_CORE_GRID_CELL_TOTALS_H
#define PLACE_MEMORY_CORE_GRID_CELL_TOTALS_H

#include <cstdint>

namespace place_memory::core {

/// How many cells a grid has of each class; the others are unsensed.
struct CellTotals {
  std::uint16_t occupied = 0;
  std::uint16_t empty = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_CELL_TOTALS_H
