#include "place_memory/core/cell_planes.h"

namespace place_memory::core {

CellPlanes::CellPlanes(const EvidenceGrid& grid) {
  for (std::size_t row = 0; row < kGridSize; ++row) {
    const std::int8_t* cells = grid.cells().data() + row * kGridSize;
    for (std::size_t column = 0; column < kGridSize; ++column) {
      const std::uint64_t bit = std::uint64_t{1} << column;
      if (cells[column] > 0) occupied[row] |= bit;
      if (cells[column] < 0) empty[row] |= bit;
    }
  }
}

}  // namespace place_memory::core
