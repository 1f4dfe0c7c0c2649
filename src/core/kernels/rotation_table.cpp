#include "core/kernels/rotation_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/grid/heading_step.h"
#include "core/kernels/byte_tiles.h"

namespace place_memory::core {
namespace {

constexpr int kQuarter = kHalfCircle / 2;  ///< heading steps
constexpr int kEighth = kQuarter / 2;      ///< heading steps

/// Of eight bytes, the lowest bit of each: that of the first byte becomes the lowest bit.
std::uint64_t gatherBits(std::uint64_t bytes) {
  return (bytes & 0x0101010101010101) * 0x0102040810204080 >> 56;
}

/// The last column first.
std::uint64_t mirrored(std::uint64_t row) {
  constexpr std::uint64_t kOnes = 0x5555555555555555, kTwos = 0x3333333333333333;
  constexpr std::uint64_t kFours = 0x0f0f0f0f0f0f0f0f;
  row = (row >> 1 & kOnes) | (row & kOnes) << 1;
  row = (row >> 2 & kTwos) | (row & kTwos) << 2;
  row = (row >> 4 & kFours) | (row & kFours) << 4;
  return __builtin_bswap64(row);
}

BitPlane transposed(BitPlane plane) {
  std::uint64_t low = 0x00000000ffffffff;
  for (std::size_t half = kGridSize / 2; half > 0; half /= 2, low ^= low << half) {
    for (std::size_t first = 0; first < kGridSize; first += 2 * half) {
      for (std::size_t row = first; row < first + half; ++row) {
        const std::uint64_t moved = (plane[row] >> half ^ plane[row + half]) & low;
        plane[row] ^= moved << half;
        plane[row + half] ^= moved;
      }
    }
  }
  return plane;
}

/// Counter-clockwise.
BitPlane rotatedByQuarters(BitPlane plane, int quarters) {
  if (quarters == 1 || quarters == 2) std::reverse(plane.begin(), plane.end());
  if (quarters == 1 || quarters == 3) plane = transposed(plane);
  if (quarters == 3) std::reverse(plane.begin(), plane.end());
  if (quarters == 2) {
    for (std::uint64_t& row : plane) row = mirrored(row);
  }
  return plane;
}

CellPlanes rotatedByQuarters(const CellPlanes& cells, int quarters) {
  CellPlanes rotated;
  rotated.occupied = rotatedByQuarters(cells.occupied, quarters);
  rotated.empty = rotatedByQuarters(cells.empty, quarters);
  return rotated;
}

/// A rotation, cell by cell and by tiles.
struct StepTable {
  explicit StepTable(double angle) : by_cell(angle), by_tile(by_cell.from()) {}

  RotationTable by_cell;
  TileTable by_tile;
};

/// A grid that is rotated again and again.
class RotatedCells {
 public:
  explicit RotatedCells(const EvidenceGrid& grid)
      : RotatedCells(CellPlanes(grid), rotatesByTiles()) {}

  CellPlanes rotate(const StepTable& table) const {
#if defined(__x86_64__)
    if (occupied_) {
      CellPlanes rotated;
      rotated.occupied = rotateByTiles(*occupied_, table.by_tile);
      rotated.empty = rotateByTiles(*empty_, table.by_tile);
      return rotated;
    }
#endif
    return table.by_cell.rotate(*bytes_);
  }

 private:
  RotatedCells(const CellPlanes& cells, bool by_tiles) {
    if (by_tiles) {
      occupied_.emplace(cells.occupied);
      empty_.emplace(cells.empty);
    } else {
      bytes_.emplace(cells);
    }
  }

  std::optional<ByteTiles> occupied_, empty_;
  std::optional<CellBytes> bytes_;
};

/// Rotations of less than an eighth; the others follow from them by quarters, but for those by odd
/// eighths, which put cells on the border of two: there, rounding decides.
struct RotationTables {
  RotationTables() {
    for (int rotation = 1 - kEighth; rotation < kEighth; ++rotation)
      small.emplace_back(rotation * kHeadingStep);
    for (int rotation = -kQuarter - kEighth; rotation <= kQuarter + kEighth; rotation += kQuarter) {
      eighths.emplace_back(rotation * kHeadingStep);
    }
  }

  std::vector<StepTable> small;
  std::vector<StepTable> eighths;  ///< by -3, -1, 1 and 3 eighths
};

}  // namespace

CellBytes::CellBytes(const EvidenceGrid& grid) {
  for (std::size_t i = 0; i < kGridCells; ++i) {
    const std::int8_t evidence = grid.cells()[i];
    classes[i] = static_cast<std::uint8_t>(evidence > 0 ? kOccupied : evidence < 0 ? kEmpty : 0);
  }
}

CellBytes::CellBytes(const CellPlanes& cells) {
  for (std::size_t i = 0; i < kGridCells; ++i) {
    const std::size_t row = i / kGridSize, column = i % kGridSize;
    const std::uint64_t occupied = cells.occupied[row] >> column & 1;
    const std::uint64_t empty = cells.empty[row] >> column & 1;
    classes[i] = static_cast<std::uint8_t>(occupied * kOccupied | empty * kEmpty);
  }
}

RotationTable::RotationTable(double angle) {
  constexpr double kMiddle = 0.5 * (kGridSize - 1);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  auto to = from_.begin();
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const double x = column - kMiddle;
      const double y = row - kMiddle;
      const long from_column = std::lround(c * x + s * y + kMiddle);
      const long from_row = std::lround(-s * x + c * y + kMiddle);
      const bool inside =
          from_column >= 0 && from_column < kGridSize && from_row >= 0 && from_row < kGridSize;
      *to++ = static_cast<std::uint16_t>(inside ? from_row * kGridSize + from_column : kGridCells);
    }
  }
}

CellPlanes RotationTable::rotate(const CellBytes& cells) const {
  CellPlanes planes;
  for (std::size_t row = 0; row < kGridSize; ++row) {
    for (std::size_t column = 0; column < kGridSize; column += 8) {
      const std::uint16_t* from = from_.data() + row * kGridSize + column;
      std::uint64_t eight = 0;
      for (std::size_t i = 0; i < 8; ++i) {
        eight |= static_cast<std::uint64_t>(cells.classes[from[i]]) << 8 * i;
      }
      planes.occupied[row] |= gatherBits(eight) << column;
      planes.empty[row] |= gatherBits(eight >> 1) << column;
    }
  }
  return planes;
}

std::vector<CellPlanes> rotatedBySteps(const EvidenceGrid& grid, int rotations) {
  static const RotationTables tables;
  const RotatedCells cells(grid);
  const int count = 2 * rotations + 1;
  std::vector<CellPlanes> rotated(static_cast<std::size_t>(count));
  const auto at = [&](int rotation) -> CellPlanes& {
    const int index = rotation + rotations;
    return rotated[static_cast<std::size_t>(index)];
  };
  for (int base = 1 - kEighth; base < kEighth; ++base) {
    if (std::abs(base) > rotations) continue;
    const int index = base + kEighth - 1;
    at(base) = cells.rotate(tables.small[static_cast<std::size_t>(index)]);
    for (const int quarters : {-2, -1, 1, 2}) {
      const int rotation = base + quarters * kQuarter;
      if (std::abs(rotation) <= rotations)
        at(rotation) = rotatedByQuarters(at(base), (quarters + 4) % 4);
    }
  }
  for (int i = 0; i < 4; ++i) {
    const int rotation = (2 * i - 3) * kEighth;
    if (std::abs(rotation) <= rotations)
      at(rotation) = cells.rotate(tables.eighths[static_cast<std::size_t>(i)]);
  }
  return rotated;
}

}  // namespace place_memory::core
