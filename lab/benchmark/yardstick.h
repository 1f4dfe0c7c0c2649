#ifndef PLACE_MEMORY_BENCHMARK_YARDSTICK_H
#define PLACE_MEMORY_BENCHMARK_YARDSTICK_H

#include <array>
#include <cstdint>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::measure {

/// Classes of a grid's cells, one byte each, row by row: -1 empty, 0 unsensed, 1 occupied.
using CellClasses = std::array<std::int8_t, core::kGridCells>;

CellClasses classesOf(const core::EvidenceGrid& grid);

struct YardstickMatch {
  core::Pose2d place_from_scan;
  int score = 0;  ///< pairs of cells of the same class
  int evaluations = 0;
};

/// What every speed is compared with: the paper's hill climb (paper 4) as it reads, one cell after
/// the other, with no bit planes and no vector instructions of its own. One climb from the compass
/// heading; with `any_heading` eight climbs from headings all around.
YardstickMatch climbByCells(const CellClasses& scan, const CellClasses& place, double cell_size,
                            bool any_heading);

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_YARDSTICK_H
