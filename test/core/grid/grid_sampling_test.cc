#include "core/grid/grid_sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::core {
namespace {

constexpr GridGeometry kGeometry{0.1};

std::size_t cellAt(int column, int row) {
  return static_cast<std::size_t>(row * kTileSize + column);
}

TEST(GridSampling, OnTheGridsOwnLatticeCellsAreTheGrids) {
  EvidenceGrid grid(kGeometry);
  grid.add(32, 32, 40);
  grid.add(33, 32, -25);
  const GridSampling sampling(grid, {}, 0.1);
  TileEvidence evidence;
  ASSERT_TRUE(sampling.sample(0, 0, evidence));
  EXPECT_EQ(evidence[cellAt(0, 0)], 40);
  EXPECT_EQ(evidence[cellAt(0, 1)], -25);
  EXPECT_EQ(evidence[cellAt(1, 0)], 0);
}

TEST(GridSampling, ATurnedGridLiesTurned) {
  EvidenceGrid grid(kGeometry);
  grid.add(32, 42, 40);  // 1.05 m ahead, 0.05 m to the left
  const GridSampling sampling(grid, {1.0, 1.0, 0.5 * kPi}, 0.1);
  TileEvidence evidence;
  ASSERT_TRUE(sampling.sample(0, 0, evidence));
  EXPECT_EQ(evidence[cellAt(9, 20)], 40);  // at (0.95, 2.05)
}

TEST(GridSampling, EvidenceRunsStraightBetweenTheCentresOfCells) {
  EvidenceGrid grid(kGeometry);
  grid.add(32, 32, 40);
  grid.add(32, 33, 80);
  const GridSampling sampling(grid, {}, 0.05);
  TileEvidence evidence;
  ASSERT_TRUE(sampling.sample(0, 0, evidence));
  // A quarter of a cell to the right of the first centre, and as far above or below it.
  EXPECT_EQ(evidence[cellAt(1, 0)], std::lround(0.75 * (0.75 * 40 + 0.25 * 80)));
  EXPECT_EQ(evidence[cellAt(2, 1)], std::lround(0.75 * (0.25 * 40 + 0.75 * 80)));
}

TEST(GridSampling, ACoarseCellKeepsAThinObstacle) {
  EvidenceGrid grid(kGeometry);
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) grid.add(row, column, -50);
  }
  grid.add(36, 37, 130);
  const GridSampling sampling(grid, {}, 1.0);
  TileEvidence evidence;
  ASSERT_TRUE(sampling.sample(0, 0, evidence));
  EXPECT_GT(evidence[cellAt(0, 0)], 60);
  EXPECT_EQ(evidence[cellAt(1, 1)], -50);
}

TEST(GridSampling, SaysNothingOfATileThatItDoesNotReach) {
  EvidenceGrid grid(kGeometry);
  grid.add(0, 0, 40);
  const GridSampling sampling(grid, {}, 0.1);
  TileEvidence evidence;
  EXPECT_TRUE(sampling.sample(-1, -1, evidence));
  EXPECT_FALSE(sampling.sample(0, 0, evidence));
  EXPECT_FALSE(sampling.sample(5, 0, evidence));
  EXPECT_EQ(sampling.span().first_column, -1);
  EXPECT_EQ(sampling.span().last_row, 0);
}

}  // namespace
}  // namespace place_memory::core
