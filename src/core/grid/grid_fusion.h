#ifndef PLACE_MEMORY_CORE_GRID_GRID_FUSION_H
#define PLACE_MEMORY_CORE_GRID_GRID_FUSION_H

#include "place_memory/core/evidence_grid.h"

namespace place_memory::core {

/// Whether and how a learned grid follows lasting changes of its place, so that no early state of
/// the world is frozen into it (paper 3.1.2).
struct AdaptationOptions {
  bool enabled = false;
  /// Share of the old evidence that a cell keeps each time it is sensed again, in [0, 1).
  double retention = 0.7;
};

/// Adds a scan's evidence to a learned grid of the same geometry. In cells that the scan sensed old
/// evidence fades to its share `retention`, in [0, 1), before; the others stay.
void fuse(const EvidenceGrid& scan, double retention, EvidenceGrid& learned);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_GRID_FUSION_H
