#ifndef PLACE_MEMORY_CORE_EXPLORE_GRID_WAYS_H
#define PLACE_MEMORY_CORE_EXPLORE_GRID_WAYS_H

#include <optional>
#include <vector>

#include "core/explore/free_space.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// The cheapest ways from one spot to every cell that the robot can reach from there (Dijkstra
/// 1959). Near things a metre counts more, so that ways keep to the middle of doors and corridors.
class GridWays {
 public:
  using Cell = FreeSpace::Cell;

  /// Keeps a reference to `space`. From a spot beyond the map no cell is reached.
  GridWays(const FreeSpace& space, const Pose2d& from, double wide_berth);

  bool reaches(Cell cell) const { return lengths_[cell] >= 0.0F; }
  /// Of the way there [m]; only where it is reached.
  double length(Cell cell) const { return static_cast<double>(lengths_[cell]); }
  /// Of the cells that are reached within `radius` the nearest to that spot; nothing where none is.
  std::optional<Cell> reachedNear(double x, double y, double radius) const;

  /// Spots to be driven to straight one after the other; the last one is the cell's middle, the
  /// spot where it begins is left out. Empty where the cell is not reached.
  std::vector<Pose2d> wayTo(Cell cell) const;

 private:
  bool isStraight(Cell from, Cell to, double room) const;

  const FreeSpace& space_;
  std::vector<float> costs_;
  std::vector<float> lengths_;  ///< below 0: not reached
  std::vector<Cell> before_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_GRID_WAYS_H
