#ifndef PLACE_MEMORY_CORE_GRID_GRID_FUSION_H
#define PLACE_MEMORY_CORE_GRID_GRID_FUSION_H

#include "place_memory/core/evidence_grid.h"

namespace place_memory::core {

/// Adds a scan's evidence to a learned grid of the same geometry. In cells that the scan sensed old
/// evidence fades to its share `retention`, in [0, 1), before; the others stay.
void fuse(const EvidenceGrid& scan, double retention, EvidenceGrid& learned);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_GRID_FUSION_H
