#include "core/kernels/cell_windows.h"

#include <algorithm>
#include <cstring>

#if defined(__x86_64__)
#include <immintrin.h>

#define PLACE_MEMORY_BITALG gnu::target("avx512f,avx512bw,avx512bitalg")
#endif

namespace place_memory::core {

CellWindows::CellWindows(const BitPlane& plane) {
  for (std::size_t column = 0; column < kGridSize; ++column) {
    std::uint8_t* const to = bytes_.data() + column * kStride;
    for (std::size_t row = 0; row < kGridSize; ++row) {
      to[row] = static_cast<std::uint8_t>(plane[row] >> column);
    }
  }
}

WindowTable::WindowTable(const std::array<std::uint16_t, kGridCells>& from) {
  for (std::size_t group = 0; group < window.size(); ++group) {
    std::size_t first_row = kGridSize, first_column = kGridSize;
    for (std::size_t i = 8 * group; i < 8 * group + 8; ++i) {
      if (from[i] >= kGridCells) continue;
      first_row = std::min<std::size_t>(first_row, from[i] / kGridSize);
      first_column = std::min<std::size_t>(first_column, from[i] % kGridSize);
    }
    if (first_row == kGridSize) continue;
    window[group] = static_cast<std::uint16_t>(first_column * CellWindows::kStride + first_row);
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
bool turnsByWindows() {
  static const bool here = [] {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx512bitalg") != 0;
  }();
  return here;
}

[[PLACE_MEMORY_BITALG]] BitPlane turnByWindows(const CellWindows& plane, const WindowTable& table) {
  BitPlane turned;
  const auto cells = [&](std::size_t group) {
    long long window;
    std::memcpy(&window, plane.data() + table.window[group], sizeof window);
    return window;
  };
  // Loads of single windows are faster than a vector's gather.
  for (std::size_t row = 0; row < kGridSize; ++row) {
    const std::size_t first = row * WindowTable::kGroups;
    const __m512i windows =
        _mm512_set_epi64(cells(first + 7), cells(first + 6), cells(first + 5), cells(first + 4),
                         cells(first + 3), cells(first + 2), cells(first + 1), cells(first));
    const __m512i bits = _mm512_load_si512(table.bit.data() + row * kGridSize);
    turned[row] = _mm512_bitshuffle_epi64_mask(windows, bits) & table.inside[row];
  }
  return turned;
}
#else
bool turnsByWindows() { return false; }
#endif

}  // namespace place_memory::core
