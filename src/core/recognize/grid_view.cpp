#include "core/recognize/grid_view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr int kOccupied = 12;  // evidence
constexpr int kEmpty = -3;     // evidence
constexpr double kNear = 1.0;  // [m]; cones are too narrow there to look everywhere

// Evidence at a point; nothing outside the grid.
std::optional<int> evidenceAt(const EvidenceGrid& grid, double x, double y) {
  const int row = grid.geometry().index(y);
  const int column = grid.geometry().index(x);
  if (row < 0 || row >= kGridSize || column < 0 || column >= kGridSize) return std::nullopt;
  return grid.at(row, column);
}

}  // namespace

GridView viewFrom(const EvidenceGrid& grid, const Pose2d& sensor, const SonarSpec& spec) {
  const std::array<double, 3> rays{-0.25 * spec.field_of_view, 0.0, 0.25 * spec.field_of_view};
  const double cell = grid.geometry().cell_size;
  GridView view;
  // The robot itself has never been sensed: what is unknown nearby is no obstacle.
  double clear = std::max(spec.min_range, 3.0 * cell);
  view.clear = clear;
  bool known = true;
  for (double range = clear; range <= spec.max_range; range += 0.5 * cell) {
    int most = -EvidenceGrid::kLimit;
    for (const double ray : rays) {
      const auto evidence = evidenceAt(grid, sensor.x + range * std::cos(sensor.yaw + ray),
                                       sensor.y + range * std::sin(sensor.yaw + ray));
      if (!evidence) return view;
      most = std::max(most, *evidence);
    }
    if (most >= kOccupied) {
      if (range - view.clear <= 3.0 * cell) view.echo = range;
      return view;
    }
    known = known && (most <= kEmpty || range < kNear);
    if (known) view.clear = range;
  }
  return view;
}

}  // namespace place_memory::core
