#ifndef PLACE_MEMORY_CORE_KERNELS_COARSE_PLANES_H
#define PLACE_MEMORY_CORE_KERNELS_COARSE_PLANES_H

#include <vector>

#include "core/grid/cell_planes.h"
#include "core/grid/cell_totals.h"
#include "core/kernels/block_kernel.h"
#include "core/kernels/plane_block.h"

namespace place_memory::core {

/// kCoarsestRows rows of planes of 16 x 16 cells, each as sixteen cells of a grid are: occupied
/// where two of them are, else empty where eight of them are. Walls are thin.
void coarsenMost(const CellPlanes& cells, QueryRow* rows);

/// The cells after each shift of a square of them: for all of `by` along y, for all of `by` along
/// x. Sets kCoarsestRows rows for each shift, and how many cells still lie on the grid. Shifts in
/// [-63, 63].
void coarsenShifted(const CellPlanes& cells, const std::vector<int>& by, QueryRow* rows,
                    CellTotals* inside);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_COARSE_PLANES_H
