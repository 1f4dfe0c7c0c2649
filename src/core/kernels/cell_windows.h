#ifndef PLACE_MEMORY_CORE_KERNELS_CELL_WINDOWS_H
#define PLACE_MEMORY_CORE_KERNELS_CELL_WINDOWS_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/grid/cell_planes.h"

namespace place_memory::core {

/// A plane so laid out that any 8 x 8 cells of it are eight bytes in a row: for each column and
/// each row, a byte of the eight cells from that column on.
class CellWindows {
 public:
  static constexpr std::size_t kStride =
      kGridSize + 8;  ///< bytes a column; windows may leave the grid

  explicit CellWindows(const BitPlane& plane);

  const std::uint8_t* data() const { return bytes_.data(); }

 private:
  std::array<std::uint8_t, kGridSize * kStride> bytes_{};
};

/// Where the cells of a turned plane come from, eight neighbours of a row at a time: these lie in a
/// window of 8 x 8 cells, however the plane is turned.
struct WindowTable {
  static constexpr std::size_t kGroups = kGridSize / 8;  ///< a row

  /// `from`: for each cell the one that it comes from; kGridCells: from outside.
  explicit WindowTable(const std::array<std::uint16_t, kGridCells>& from);

  alignas(64) std::array<std::uint8_t, kGridCells> bit{};  ///< of the window
  alignas(64) std::array<std::uint16_t, kGridCells / 8> window{};
  BitPlane inside{};  ///< cells that do not come from outside
};

/// Whether this processor has the instructions for turnByWindows().
bool turnsByWindows();

#if defined(__x86_64__)
BitPlane turnByWindows(const CellWindows& plane, const WindowTable& table);
#endif

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_CELL_WINDOWS_H
