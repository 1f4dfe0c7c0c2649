#ifndef PLACE_MEMORY_CORE_KERNELS_PLANE_BLOCK_H
#define PLACE_MEMORY_CORE_KERNELS_PLANE_BLOCK_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/grid/cell_planes.h"

namespace place_memory::core {

/// Places whose bit planes are kept together.
constexpr std::size_t kBlockPlaces = 8;

/// The same row of the planes of eight places, so that one vector holds it for several of them.
struct alignas(64) BlockRow {
  std::array<std::uint64_t, kBlockPlaces> occupied{};
  std::array<std::uint64_t, kBlockPlaces> empty{};
};

/// The classes of the cells of eight places, row by row. A slot that was never set is unsensed.
struct PlaneBlock {
  std::array<BlockRow, kGridSize> rows;

  /// Slot in [0, kBlockPlaces).
  void set(std::size_t slot, const CellPlanes& cells);
  CellPlanes get(std::size_t slot) const;
};

/// The classes of 16 x 16 cells, each of sixteen cells of a grid, in no order that matters: the
/// same bits of two grids stand for the same cells.
constexpr std::size_t kCoarsestRows = 4;
using CoarsestBlock = std::array<BlockRow, kCoarsestRows>;

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_PLANE_BLOCK_H
