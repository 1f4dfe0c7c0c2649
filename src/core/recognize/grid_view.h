#ifndef PLACE_MEMORY_CORE_RECOGNIZE_GRID_VIEW_H
#define PLACE_MEMORY_CORE_RECOGNIZE_GRID_VIEW_H

#include <optional>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// What a sensor should hear by a learned grid.
struct GridView {
  double clear = 0.0;          ///< the inner half of the cone is known to be empty so far [m]
  std::optional<double> echo;  ///< from here [m], within the sensor's limits, and nothing hides it
};

/// `sensor` is the sensor's pose in the grid's frame.
GridView viewFrom(const EvidenceGrid& grid, const Pose2d& sensor, const SonarSpec& spec);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_GRID_VIEW_H
