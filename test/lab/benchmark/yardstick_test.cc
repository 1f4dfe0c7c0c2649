#include "benchmark/yardstick.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace place_memory::measure {
namespace {

/// A closed room with a box in it, some cells off the middle.
CellClasses room(int columns, int rows) {
  core::EvidenceGrid grid;
  for (int row = 16; row <= 44; ++row) {
    for (int column = 14; column <= 50; ++column) {
      const bool wall = row == 16 || row == 44 || column == 14 || column == 50;
      const bool box = row > 20 && row < 26 && column > 20 && column < 30;
      grid.add(row + rows, column + columns, wall || box ? 40 : -20);
    }
  }
  return classesOf(grid);
}

TEST(Yardstick, TellsClassesByTheSignOfTheEvidence) {
  core::EvidenceGrid grid;
  grid.add(0, 1, 5);
  grid.add(0, 2, -5);
  const CellClasses classes = classesOf(grid);
  EXPECT_EQ(classes[0], 0);
  EXPECT_EQ(classes[1], 1);
  EXPECT_EQ(classes[2], -1);
}

TEST(Yardstick, GivesAPointForEachCellWhereGridsAgree) {
  const YardstickMatch match = climbByCells(room(0, 0), room(0, 0), core::kDefaultCellSize, false);
  EXPECT_EQ(match.score, core::kGridCells);
  EXPECT_EQ(match.place_from_scan.x, 0.0);
  EXPECT_EQ(match.place_from_scan.yaw, 0.0);
}

TEST(Yardstick, ClimbsToWhereTheRoomLies) {
  const YardstickMatch match = climbByCells(room(0, 0), room(3, -2), core::kDefaultCellSize, false);
  EXPECT_NEAR(match.place_from_scan.x, 3 * core::kDefaultCellSize, 0.5 * core::kDefaultCellSize);
  EXPECT_NEAR(match.place_from_scan.y, -2 * core::kDefaultCellSize, 0.5 * core::kDefaultCellSize);
  EXPECT_NEAR(match.place_from_scan.yaw, 0.0, 0.02);
  EXPECT_GT(match.evaluations, 10);
}

TEST(Yardstick, FindsAnyHeadingFromEightStarts) {
  CellClasses rotated{};  // by a half rotation
  const CellClasses upright = room(0, 0);
  std::reverse_copy(upright.begin(), upright.end(), rotated.begin());
  const YardstickMatch blind = climbByCells(upright, rotated, core::kDefaultCellSize, false);
  const YardstickMatch match = climbByCells(upright, rotated, core::kDefaultCellSize, true);
  EXPECT_EQ(match.score, core::kGridCells);
  EXPECT_NEAR(std::abs(match.place_from_scan.yaw), core::kPi, 1e-9);
  EXPECT_LT(blind.score, match.score);
}

}  // namespace
}  // namespace place_memory::measure
