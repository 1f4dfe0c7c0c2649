#ifndef PLACE_MEMORY_CORE_GRID_GEOMETRY_H
#define PLACE_MEMORY_CORE_GRID_GEOMETRY_H

#include <cmath>

namespace place_memory::core {

/// Cells along each side of every grid: a row of a bit plane is then one machine word
/// (paper 3.1.4).
constexpr int kGridSize = 64;
constexpr int kGridCells = kGridSize * kGridSize;

/// 30 ft over 64 cells, the paper's grid [m] (paper 3.1.4).
constexpr double kDefaultCellSize = 30.0 * 0.3048 / kGridSize;

/// Where the cells of a 64 x 64 grid lie: its centre is the origin of the frame it is in, columns
/// run along x, rows along y, and the cell in row 0 and column 0 has the least x and y.
struct GridGeometry {
  double cell_size = kDefaultCellSize;  ///< side of a cell [m], > 0

  /// Coordinate of the centre of a column (x) or a row (y) [m].
  double centre(int index) const { return (index - 0.5 * (kGridSize - 1)) * cell_size; }

  /// Column of an x or row of a y [m]; outside the grid it is below 0 or above 63.
  int index(double coordinate) const {
    return static_cast<int>(std::floor(coordinate / cell_size + 0.5 * kGridSize));
  }

  /// Distance from the centre to an edge [m].
  double halfWidth() const { return 0.5 * kGridSize * cell_size; }
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_GRID_GEOMETRY_H
