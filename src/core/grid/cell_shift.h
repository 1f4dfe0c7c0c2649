#ifndef PLACE_MEMORY_CORE_GRID_CELL_SHIFT_H
#define PLACE_MEMORY_CORE_GRID_CELL_SHIFT_H

namespace place_memory::core {

/// A translation by whole cells.
struct CellShift {
  int columns = 0;  ///< along x
  int rows = 0;     ///< along y
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_CELL_SHIFT_H
