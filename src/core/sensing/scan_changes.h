#ifndef PLACE_MEMORY_CORE_SENSING_SCAN_CHANGES_H
#define PLACE_MEMORY_CORE_SENSING_SCAN_CHANGES_H

#include <vector>

#include "core/grid/grid_changes.h"
#include "place_memory/core/sonar_model.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// Chosen in the simulated office; `place_memory_reports changes` says how often they are right.
constexpr GridChangeOptions kScanChangeOptions{30, 3};

/// What has changed from one scan to the other, both in the frame of the grid: the largest first.
///
/// Sound that passed a cell counts twice as much here as in a grid that places are known by. In an
/// open doorway the jambs echo as a closed door would, and wide cones smear those echoes all over
/// the opening; but through a closed door hardly anything is heard.
std::vector<GridChange> changesBetween(const std::vector<SonarReading>& before,
                                       const std::vector<SonarReading>& now,
                                       const SonarModelOptions& sonar, const GridGeometry& geometry,
                                       const GridChangeOptions& options = kScanChangeOptions);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_SCAN_CHANGES_H
