#ifndef PLACE_MEMORY_CORE_GRID_HEADING_STEP_H
#define PLACE_MEMORY_CORE_GRID_HEADING_STEP_H

#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// Step of the heading in every search [rad]: at the rim of the grid it moves a cell by less than
/// two cells.
constexpr double kHeadingStep = 3.0 * kPi / 180.0;
constexpr int kHalfCircle = 60;  ///< heading steps in pi

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_HEADING_STEP_H
