#ifndef PLACE_MEMORY_TEST_CORE_EXPLORE_FLOOR_PLAN_H
#define PLACE_MEMORY_TEST_CORE_EXPLORE_FLOOR_PLAN_H

#include <cstdint>
#include <string>
#include <vector>

#include "core/explore/surveyed_map.h"

namespace place_memory::core {

constexpr double kPlanCell = 0.1;  ///< [m]

/// A map as it is drawn, the top row first: '#' is occupied, '.' empty, anything else unknown. Each
/// character stands for a square of so many cells; the lower left corner is the map's origin.
inline SurveyedCells floorPlan(const std::vector<std::string>& rows, int scale) {
  SurveyedCells survey;
  FusedCells& cells = survey.cells;
  cells.resolution = kPlanCell;
  cells.columns = static_cast<int>(rows.front().size()) * scale;
  cells.rows = static_cast<int>(rows.size()) * scale;
  for (int row = 0; row < cells.rows; ++row) {
    const std::string& drawn = rows[rows.size() - 1 - static_cast<std::size_t>(row / scale)];
    for (int column = 0; column < cells.columns; ++column) {
      const char mark = drawn[static_cast<std::size_t>(column / scale)];
      const int evidence = mark == '#' ? 100 : mark == '.' ? -100 : 0;
      cells.evidence.push_back(static_cast<std::int8_t>(evidence));
    }
  }
  return survey;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_EXPLORE_FLOOR_PLAN_H
