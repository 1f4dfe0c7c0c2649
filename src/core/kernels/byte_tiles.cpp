#include "core/kernels/byte_tiles.h"

#include <algorithm>
#include <cstring>

#include "core/kernels/cpu.h"

#if defined(__x86_64__)
#include <immintrin.h>

#define PLACE_MEMORY_BITALG gnu::target("avx512f,avx512bw,avx512bitalg")
#endif

namespace place_memory::core {

ByteTiles::ByteTiles(const BitPlane& plane) {
  for (std::size_t column = 0; column < kGridSize; ++column) {
    std::uint8_t* const to = bytes_.data() + column * kStride;
    for (std::size_t row = 0; row < kGridSize; ++row) {
      to[row] = static_cast<std::uint8_t>(plane[row] >> column);
    }
  }
}

TileTable::TileTable(const std::array<std::uint16_t, kGridCells>& from) {
  for (std::size_t group = 0; group < tile.size(); ++group) {
    std::size_t first_row = kGridSize, first_column = kGridSize;
    for (std::size_t i = 8 * group; i < 8 * group + 8; ++i) {
      if (from[i] >= kGridCells) continue;
      first_row = std::min<std::size_t>(first_row, from[i] / kGridSize);
      first_column = std::min<std::size_t>(first_column, from[i] % kGridSize);
    }
    if (first_row == kGridSize) continue;
    tile[group] = static_cast<std::uint16_t>(first_column * ByteTiles::kStride + first_row);
    for (std::size_t i = 8 * group; i < 8 * group + 8; ++i) {
      if (from[i] >= kGridCells) continue;
      const std::size_t row = from[i] / kGridSize - first_row;
      const std::size_t column = from[i] % kGridSize - first_column;
      bit[i] = static_cast<std::uint8_t>(8 * row + column);
      inside[i / kGridSize] |= std::uint64_t{1} << i % kGridSize;
    }
  }
}

#if defined(__x86_64__)
bool rotatesByTiles() { return chosenInstructionSet() >= InstructionSet::kAvx512; }

[[PLACE_MEMORY_BITALG]] BitPlane rotateByTiles(const ByteTiles& plane, const TileTable& table) {
  BitPlane rotated;
  const auto cells = [&](std::size_t group) {
    long long tile;
    std::memcpy(&tile, plane.data() + table.tile[group], sizeof tile);
    return tile;
  };
  // Loads of single tiles are faster than a vector's gather.
  for (std::size_t row = 0; row < kGridSize; ++row) {
    const std::size_t first = row * TileTable::kGroups;
    const __m512i tiles =
        _mm512_set_epi64(cells(first + 7), cells(first + 6), cells(first + 5), cells(first + 4),
                         cells(first + 3), cells(first + 2), cells(first + 1), cells(first));
    const __m512i bits = _mm512_load_si512(table.bit.data() + row * kGridSize);
    rotated[row] = _mm512_bitshuffle_epi64_mask(tiles, bits) & table.inside[row];
  }
  return rotated;
}
#else
bool rotatesByTiles() { return false; }
#endif

}  // namespace place_memory::core
