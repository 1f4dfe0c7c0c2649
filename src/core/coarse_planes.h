#ifndef PLACE_MEMORY_CORE_COARSE_PLANES_H
#define PLACE_MEMORY_CORE_COARSE_PLANES_H

#include <vector>

#include "block_kernel.h"
#include "place_memory/core/cell_planes.h"
#include "place_memory/core/plane_block.h"
#include "place_memory/core/query_planes.h"

namespace place_memory::core {

/// Rows of planes of 32 x 32 cells, each as four cells of a grid are: occupied where two of them
/// are, else empty where two of them are.
constexpr std::size_t kCoarseRows = 16;
void coarsen(const CellPlanes& cells, QueryRow* rows);

/// kCoarseRows for each of the shifts, which are even.
void coarsenShifted(const CellPlanes& cells, const std::vector<CellShift>& shifts, QueryRow* rows);

/// Likewise kCoarsestRows of 16 x 16 cells: occupied where two of the sixteen are, else empty where
/// eight of them are. Walls are thin.
void coarsenMost(const CellPlanes& cells, QueryRow* rows);

/// kCoarsestRows for each of the shifts.
void coarsenMostShifted(const CellPlanes& cells, const std::vector<CellShift>& shifts,
                        QueryRow* rows);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_COARSE_PLANES_H
