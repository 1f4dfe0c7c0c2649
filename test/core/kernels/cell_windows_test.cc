#include "core/kernels/cell_windows.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "core/kernels/turn_table.h"
#include "core/match/lattice.h"

namespace place_memory::core {
namespace {

TEST(CellWindows, TurnAsCellByCell) {
  if (!turnsByWindows()) {
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
    const CellWindows windows(cells.occupied);
    for (int turn = -kHalfCircle; turn <= kHalfCircle; ++turn) {
      for (const double off : {0.0, 0.31}) {
        const TurnTable table((turn + off) * kHeadingStep);
        ASSERT_EQ(turnByWindows(windows, WindowTable(table.from())),
                  table.turn(CellBytes(cells)).occupied)
            << turn + off << " steps";
      }
    }
  }
#endif
}

}  // namespace
}  // namespace place_memory::core
