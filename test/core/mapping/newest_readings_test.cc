#include "core/mapping/newest_readings.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

/// A wall along a row, free space before it.
CellPlanes wall(int row, int last_row_seen = 63) {
  EvidenceGrid grid;
  for (int column = 10; column < 50; ++column) {
    for (int free = 10; free < std::min(row, last_row_seen); ++free) grid.add(free, column, -20);
    if (row <= last_row_seen) grid.add(row, column, 40);
  }
  return CellPlanes(grid);
}

TEST(NewestReadings, TheSameWallAgreesAndSoDoesOneACellOff) {
  EXPECT_DOUBLE_EQ(agreement(wall(40), wall(40)).value(), 1.0);
  EXPECT_GT(agreement(wall(41), wall(40)).value(), 0.9);
}

TEST(NewestReadings, AWallInTheOpenDoesNot) {
  EXPECT_LT(agreement(wall(30), wall(40)).value(), 0.1);
  EXPECT_LT(agreement(wall(40), wall(30)).value(), 0.1);
}

TEST(NewestReadings, WhereLittleIsSeenNothingIsSaid) {
  EXPECT_FALSE(agreement(CellPlanes(), wall(40)));
  EXPECT_FALSE(agreement(wall(40, 30), CellPlanes()));
}

}  // namespace
}  // namespace place_memory::core
