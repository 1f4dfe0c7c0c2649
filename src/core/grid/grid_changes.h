#ifndef PLACE_MEMORY_CORE_GRID_GRID_CHANGES_H
#define PLACE_MEMORY_CORE_GRID_GRID_CHANGES_H

#include <cstddef>
#include <vector>

#include "place_memory/core/evidence_grid.h"

namespace place_memory::core {

/// Something that stands where nothing stood, or no longer stands where it did.
struct GridChange {
  bool appeared = false;  ///< false: it is gone
  double x = 0.0;         ///< of its middle, in the grid's frame [m]
  double y = 0.0;
  double size = 0.0;  ///< its longer side along x or y [m]
  std::size_t cells = 0;
};

struct GridChangeOptions {
  /// Of a cell that counts as occupied or empty for certain [1 / EvidenceGrid::kStepsPerNat nats].
  int sure = 25;
  std::size_t least_cells = 3;  ///< of a change, which hang together
};

/// What has changed from one grid to the other, which lies in the same frame: the largest first.
/// Cells that either of them does not know for certain say nothing.
std::vector<GridChange> changesBetween(const EvidenceGrid& before, const EvidenceGrid& now,
                                       const GridChangeOptions& options = {});

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_GRID_CHANGES_H
