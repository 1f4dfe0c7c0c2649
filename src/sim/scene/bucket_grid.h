#ifndef PLACE_MEMORY_SIM_SCENE_BUCKET_GRID_H
#define PLACE_MEMORY_SIM_SCENE_BUCKET_GRID_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/world/vec2.h"

namespace place_memory::sim {

/// A uniform grid of square cells, each with the ids of the items that touch it, so that a ray or a
/// disc looks only at what is near. Ids are stored cell after cell in one array.
class BucketGrid {
 public:
  /// An item as the grid sees it: a segment thickened by `radius` (a circle has a == b).
  struct Item {
    Vec2 a;
    Vec2 b;
    double radius = 0.0;
  };

  BucketGrid() = default;

  /// Ids are indices into `items`. All items lie within the bounds.
  BucketGrid(Vec2 lower, Vec2 upper, double cell_size, const std::vector<Item>& items);

  /// Calls `visit(id)` for the items in the cells that the ray crosses, near cells first, until a
  /// cell begins beyond `reach()` [m]. An item in several cells is visited several times.
  template <typename Reach, typename Visit>
  void walkRay(Vec2 origin, Vec2 direction, Reach reach, Visit visit) const;

  /// Calls `visit(id)` for the items in the cells that the square about `center` overlaps.
  template <typename Visit>
  void visitSquare(Vec2 center, double half_width, Visit visit) const;

 private:
  struct Axis {
    int cell;
    int step;
    double next;   // distance along the ray to the next cell border
    double delta;  // distance along the ray from border to border
  };

  int clampedCell(double position, double lower, int count) const {
    const double cell = std::floor((position - lower) / cell_size_);
    return static_cast<int>(std::min(std::max(cell, 0.0), static_cast<double>(count - 1)));
  }
  std::size_t cellIndex(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  Axis startAxis(double position, double lower, double direction, int count, double entry) const;
  bool entersAt(Vec2 origin, Vec2 direction, double& entry) const;

  template <typename Visit>
  void visitCell(int column, int row, Visit& visit) const {
    const auto cell = cellIndex(column, row);
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) visit(ids_[i]);
  }

  Vec2 lower_;
  Vec2 upper_;
  double cell_size_ = 1.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> ids_;
};

template <typename Reach, typename Visit>
void BucketGrid::walkRay(Vec2 origin, Vec2 direction, Reach reach, Visit visit) const {
  double entry = 0.0;
  if (columns_ == 0 || !entersAt(origin, direction, entry)) return;
  const Vec2 start = origin + direction * entry;
  Axis x = startAxis(start.x, lower_.x, direction.x, columns_, entry);
  Axis y = startAxis(start.y, lower_.y, direction.y, rows_, entry);
  double at = entry;
  while (at <= reach()) {
    visitCell(x.cell, y.cell, visit);
    Axis& axis = x.next < y.next ? x : y;
    at = axis.next;
    axis.cell += axis.step;
    axis.next += axis.delta;
    if (x.cell < 0 || x.cell >= columns_ || y.cell < 0 || y.cell >= rows_) return;
  }
}

template <typename Visit>
void BucketGrid::visitSquare(Vec2 center, double half_width, Visit visit) const {
  if (columns_ == 0) return;
  const int last_column = clampedCell(center.x + half_width, lower_.x, columns_);
  const int last_row = clampedCell(center.y + half_width, lower_.y, rows_);
  for (int row = clampedCell(center.y - half_width, lower_.y, rows_); row <= last_row; ++row) {
    for (int column = clampedCell(center.x - half_width, lower_.x, columns_); column <= last_column;
         ++column) {
      visitCell(column, row, visit);
    }
  }
}

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_BUCKET_GRID_H
