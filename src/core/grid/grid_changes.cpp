#include "core/grid/grid_changes.h"

#include <algorithm>
#include <array>
#include <vector>

namespace place_memory::core {
namespace {

struct At {
  int row = 0;
  int column = 0;
};

bool isInside(int row, int column) {
  return row >= 0 && row < kGridSize && column >= 0 && column < kGridSize;
}

/// Cells that are to be gathered into changes.
class Marks {
 public:
  bool& at(int row, int column) { return marks_[index(row, column)]; }

  /// Takes the marks out that are connected with this one, over corners too.
  std::vector<At> take(int row, int column) {
    std::vector<At> cells;
    std::vector<At> open{{row, column}};
    at(row, column) = false;
    while (!open.empty()) {
      const At cell = open.back();
      open.pop_back();
      cells.push_back(cell);
      for (int r = cell.row - 1; r <= cell.row + 1; ++r) {
        for (int c = cell.column - 1; c <= cell.column + 1; ++c) {
          if (!isInside(r, c) || !at(r, c)) continue;
          at(r, c) = false;
          open.push_back({r, c});
        }
      }
    }
    return cells;
  }

 private:
  static std::size_t index(int row, int column) {
    return static_cast<std::size_t>(row) * kGridSize + static_cast<std::size_t>(column);
  }

  std::array<bool, kGridCells> marks_{};
};

GridChange changeOf(const std::vector<At>& cells, const GridGeometry& geometry, bool appeared) {
  GridChange change;
  change.appeared = appeared;
  change.cells = cells.size();
  At least = cells.front();
  At most = least;
  for (const At& cell : cells) {
    change.x += geometry.centre(cell.column) / static_cast<double>(cells.size());
    change.y += geometry.centre(cell.row) / static_cast<double>(cells.size());
    least = {std::min(least.row, cell.row), std::min(least.column, cell.column)};
    most = {std::max(most.row, cell.row), std::max(most.column, cell.column)};
  }
  const int longer = std::max(most.row - least.row, most.column - least.column);
  change.size = (longer + 1) * geometry.cell_size;
  return change;
}

/// Of what stands in `occupied` and not in `empty`.
void gather(const EvidenceGrid& occupied, const EvidenceGrid& empty,
            const GridChangeOptions& options, bool appeared, std::vector<GridChange>& changes) {
  Marks marks;
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      marks.at(row, column) =
          occupied.at(row, column) >= options.sure && empty.at(row, column) <= -options.sure;
    }
  }
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      if (!marks.at(row, column)) continue;
      const std::vector<At> cells = marks.take(row, column);
      if (cells.size() < options.least_cells) continue;
      changes.push_back(changeOf(cells, occupied.geometry(), appeared));
    }
  }
}

}  // namespace

std::vector<GridChange> changesBetween(const EvidenceGrid& before, const EvidenceGrid& now,
                                       const GridChangeOptions& options) {
  std::vector<GridChange> changes;
  gather(now, before, options, true, changes);
  gather(before, now, options, false, changes);
  std::stable_sort(
      changes.begin(), changes.end(),
      [](const GridChange& one, const GridChange& other) { return one.cells > other.cells; });
  return changes;
}

}  // namespace place_memory::core
