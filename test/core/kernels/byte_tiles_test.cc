#include "core/kernels/byte_tiles.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "core/kernels/rotation_table.h"
#include "core/match/lattice.h"

namespace place_memory::core {
namespace {

TEST(ByteTiles, RotateAsCellByCell) {
  if (!rotatesByTiles()) {
    std::cout << "not on this processor\n";
    return;
  }
#if defined(__x86_64__)
  std::mt19937_64 engine(9);
  for (const int kind : {0, 1, 2}) {
    CellPlanes cells;
    for (std::uint64_t& row : cells.occupied) {
      row = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : engine();
    }
    const ByteTiles tiles(cells.occupied);
    for (int rotation = -kHalfCircle; rotation <= kHalfCircle; ++rotation) {
      for (const double off : {0.0, 0.31}) {
        const RotationTable table((rotation + off) * kHeadingStep);
        ASSERT_EQ(rotateByTiles(tiles, TileTable(table.from())),
                  table.rotate(CellBytes(cells)).occupied)
            << rotation + off << " steps";
      }
    }
  }
#endif
}

}  // namespace
}  // namespace place_memory::core
