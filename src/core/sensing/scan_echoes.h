#ifndef PLACE_MEMORY_CORE_SENSING_SCAN_ECHOES_H
#define PLACE_MEMORY_CORE_SENSING_SCAN_ECHOES_H

#include <cstdint>
#include <vector>

#include "place_memory/core/grid_geometry.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// Readings, in the grid's frame, with an echo whose spot on the cone's axis lies in the grid.
std::uint32_t countEchoes(const std::vector<SonarReading>& readings, const GridGeometry& geometry);

/// Whether an echo lies in the scan's grid and has made a cell occupied: a scan without tells
/// nothing of where it was taken. Without readings the grid alone is asked.
bool holdsEcho(const Scan& scan);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_SCAN_ECHOES_H
