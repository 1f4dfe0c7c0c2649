#ifndef PLACE_MEMORY_CORE_KERNELS_BYTE_TILES_H
#define PLACE_MEMORY_CORE_KERNELS_BYTE_TILES_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/grid/cell_planes.h"

namespace place_memory::core {

/// A plane so laid out that any tile of 8 x 8 cells is eight bytes in a row: for each column and
/// each row, a byte of the eight cells from that column on.
class ByteTiles {
 public:
  static constexpr std::size_t kStride =
      kGridSize + 8;  ///< bytes a column; tiles may reach beyond the grid

  explicit ByteTiles(const BitPlane& plane);

  const std::uint8_t* data() const { return bytes_.data(); }

 private:
  std::array<std::uint8_t, kGridSize * kStride> bytes_{};
};

/// Where the cells of a rotated plane come from, eight neighbours of a row at a time: these lie in
/// a tile of 8 x 8 cells, however the plane is rotated.
struct TileTable {
  static constexpr std::size_t kGroups = kGridSize / 8;  ///< a row

  /// `from`: for each cell the one that it comes from; kGridCells: from outside.
  explicit TileTable(const std::array<std::uint16_t, kGridCells>& from);

  alignas(64) std::array<std::uint8_t, kGridCells> bit{};        ///< of the tile
  alignas(64) std::array<std::uint16_t, kGridCells / 8> tile{};  ///< where it begins [bytes]
  BitPlane inside{};  ///< cells that do not come from outside
};

/// Whether rotateByTiles() is there and chosenInstructionSet() allows it.
bool rotatesByTiles();

#if defined(__x86_64__)
BitPlane rotateByTiles(const ByteTiles& plane, const TileTable& table);
#endif

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_BYTE_TILES_H
