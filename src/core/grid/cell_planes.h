#ifndef PLACE_MEMORY_CORE_GRID_CELL_PLANES_H
#define PLACE_MEMORY_CORE_GRID_CELL_PLANES_H

#include <array>
#include <cstdint>

#include "place_memory/core/evidence_grid.h"

namespace place_memory::core {

/// One bit a cell: element r is row r, bit c of it is column c.
using BitPlane = std::array<std::uint64_t, kGridSize>;

/// The classes of a grid's cells as bit planes: occupied, empty, and neither of them unsensed.
struct CellPlanes {
  alignas(64) BitPlane occupied{};
  alignas(64) BitPlane empty{};

  CellPlanes() = default;
  /// Classes by the sign of the evidence (paper 4).
  explicit CellPlanes(const EvidenceGrid& grid);
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_CELL_PLANES_H
