#ifndef PLACE_MEMORY_CORE_KERNELS_ROTATION_TABLE_H
#define PLACE_MEMORY_CORE_KERNELS_ROTATION_TABLE_H

#include <array>
#include <cstdint>
#include <vector>

#include "core/grid/cell_planes.h"

namespace place_memory::core {

/// The class of each cell of a grid in a byte of its own, row by row, and behind them an unsensed
/// one.
struct CellBytes {
  static constexpr std::uint8_t kOccupied = 1;
  static constexpr std::uint8_t kEmpty = 2;

  explicit CellBytes(const EvidenceGrid& grid);
  explicit CellBytes(const CellPlanes& cells);

  std::array<std::uint8_t, kGridCells + 1> classes{};
};

/// Where each cell of a grid comes from when the grid is rotated about its centre, as rotated()
/// does it.
class RotationTable {
 public:
  explicit RotationTable(double angle);

  CellPlanes rotate(const CellBytes& cells) const;
  /// For each cell the one that it comes from; kGridCells: from outside.
  const std::array<std::uint16_t, kGridCells>& from() const { return from_; }

 private:
  std::array<std::uint16_t, kGridCells> from_;
};

/// The grid rotated by -`rotations` to `rotations` heading steps (kHeadingStep) in [0,
/// kHalfCircle].
std::vector<CellPlanes> rotatedBySteps(const EvidenceGrid& grid, int rotations);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_ROTATION_TABLE_H
