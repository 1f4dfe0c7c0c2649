#include "core/kernels/plane_block.h"

namespace place_memory::core {

void PlaneBlock::set(std::size_t slot, const CellPlanes& cells) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    rows[row].occupied[slot] = cells.occupied[row];
    rows[row].empty[slot] = cells.empty[row];
  }
}

CellPlanes PlaneBlock::get(std::size_t slot) const {
  CellPlanes cells;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    cells.occupied[row] = rows[row].occupied[slot];
    cells.empty[row] = rows[row].empty[slot];
  }
  return cells;
}

}  // namespace place_memory::core
