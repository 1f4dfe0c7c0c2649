#include "core/grid/grid_changes.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

/// Empty but for a wall along row 50.
EvidenceGrid room() {
  EvidenceGrid grid;
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) grid.add(row, column, -60);
  }
  for (int column = 0; column < kGridSize; ++column) grid.add(50, column, 120);
  return grid;
}

void put(EvidenceGrid& grid, int row, int column, int evidence) {
  for (int r = row; r < row + 3; ++r) {
    for (int c = column; c < column + 2; ++c) grid.add(r, c, evidence);
  }
}

TEST(GridChanges, NothingIsTheSame) { EXPECT_TRUE(changesBetween(room(), room()).empty()); }

TEST(GridChanges, AThingThatCameAndADoorThatOpened) {
  EvidenceGrid now = room();
  put(now, 10, 20, 120);
  for (int column = 30; column < 36; ++column) now.add(50, column, -120);
  const std::vector<GridChange> changes = changesBetween(room(), now);
  ASSERT_EQ(changes.size(), 2U);
  const GridGeometry geometry;
  EXPECT_EQ(changes[0].cells, 6U);
  EXPECT_EQ(changes[1].cells, 6U);
  const GridChange& came = changes[0];  // what came is before what went where they are as large
  EXPECT_TRUE(came.appeared);
  EXPECT_NEAR(came.x, 0.5 * (geometry.centre(20) + geometry.centre(21)), 1e-9);
  EXPECT_NEAR(came.y, geometry.centre(11), 1e-9);
  EXPECT_NEAR(came.size, 3 * geometry.cell_size, 1e-9);
  const GridChange& opened = changes[1];
  EXPECT_FALSE(opened.appeared);
  EXPECT_NEAR(opened.x, 0.5 * (geometry.centre(30) + geometry.centre(35)), 1e-9);
  EXPECT_NEAR(opened.size, 6 * geometry.cell_size, 1e-9);
}

TEST(GridChanges, WhatIsNotKnownForCertainSaysNothing) {
  EvidenceGrid unsensed;
  EXPECT_TRUE(changesBetween(room(), unsensed).empty());
  EXPECT_TRUE(changesBetween(unsensed, room()).empty());
  EvidenceGrid doubtful = room();
  put(doubtful, 10, 20, 80);  // +20: less than sure
  EXPECT_TRUE(changesBetween(room(), doubtful).empty());
}

TEST(GridChanges, AFewCellsAreNoise) {
  EvidenceGrid now = room();
  now.add(10, 20, 120);
  now.add(11, 21, 120);
  EXPECT_TRUE(changesBetween(room(), now).empty());
  now.add(12, 22, 120);  // they hang together over corners
  EXPECT_EQ(changesBetween(room(), now).size(), 1U);
}

}  // namespace
}  // namespace place_memory::core
