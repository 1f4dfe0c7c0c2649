#include "place_memory/core/evidence_grid.h"

#include <gtest/gtest.h>

#include <random>

namespace place_memory::core {
namespace {

std::size_t offset(int row, int column) {
  return static_cast<std::size_t>(row) * kGridSize + static_cast<std::size_t>(column);
}

TEST(EvidenceGrid, StartsAtThePrior) {
  const EvidenceGrid grid;
  EXPECT_DOUBLE_EQ(grid.geometry().cell_size, 30.0 * 0.3048 / 64.0);
  for (const std::int8_t cell : grid.cells()) EXPECT_EQ(cell, 0);
}

TEST(EvidenceGrid, AnUpdateIsOneAdditionInItsCellAlone) {
  EvidenceGrid grid;
  grid.add(5, 9, 20);
  grid.add(5, 9, -3);
  EXPECT_EQ(grid.at(5, 9), 17);
  for (int i = 0; i < kGridCells; ++i) {
    EXPECT_EQ(grid.cells()[static_cast<std::size_t>(i)], i == 5 * kGridSize + 9 ? 17 : 0) << i;
  }
}

TEST(EvidenceGrid, EveryCellHasItsOwnByte) {
  EvidenceGrid grid;
  std::mt19937 engine(11);
  std::uniform_int_distribution<int> evidence(-EvidenceGrid::kLimit, EvidenceGrid::kLimit);
  std::array<int, kGridCells> expected{};
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const int value = evidence(engine);
      expected[offset(row, column)] = value;
      grid.add(row, column, value);
    }
  }
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const std::size_t at = offset(row, column);
      ASSERT_EQ(grid.at(row, column), expected[at]);
      ASSERT_EQ(grid.cells()[at], expected[at]);
    }
  }
}

TEST(EvidenceGrid, SaturatesAtEitherLimit) {
  EvidenceGrid grid;
  for (int i = 0; i < 100; ++i) {
    grid.add(0, 0, 50);
    grid.add(63, 63, -50);
  }
  EXPECT_EQ(grid.at(0, 0), EvidenceGrid::kLimit);
  EXPECT_EQ(grid.at(63, 63), -EvidenceGrid::kLimit);
  grid.add(1, 1, 100000);
  grid.add(1, 2, -100000);
  EXPECT_EQ(grid.at(1, 1), EvidenceGrid::kLimit);
  EXPECT_EQ(grid.at(1, 2), -EvidenceGrid::kLimit);
}

TEST(EvidenceGrid, ASaturatedCellCanStillChangeItsMind) {
  EvidenceGrid grid;
  grid.add(3, 4, 1000);
  grid.add(3, 4, -EvidenceGrid::kLimit - 1);
  EXPECT_EQ(grid.at(3, 4), -1);
}

TEST(EvidenceGrid, ProbabilityOfNoEvidenceIsThePrior) {
  for (const double prior : {0.01, 0.25, 0.5, 0.9}) {
    EXPECT_NEAR(EvidenceGrid::probability(0, prior), prior, 1e-12);
  }
}

TEST(EvidenceGrid, ProbabilityRisesWithEvidenceAndFollowsTheOdds) {
  for (const double prior : {0.1, 0.5, 0.7}) {
    for (int evidence = -EvidenceGrid::kLimit; evidence <= EvidenceGrid::kLimit; ++evidence) {
      const double probability = EvidenceGrid::probability(evidence, prior);
      const double odds = prior / (1.0 - prior) *
                          std::exp(static_cast<double>(evidence) / EvidenceGrid::kStepsPerNat);
      EXPECT_NEAR(probability, odds / (1.0 + odds), 1e-9);
      EXPECT_GT(probability, EvidenceGrid::probability(evidence - 1, prior));
    }
  }
}

TEST(EvidenceGrid, EqualWhereCellsAndCellSizeAre) {
  EvidenceGrid a(GridGeometry{0.1});
  EvidenceGrid b(GridGeometry{0.1});
  EXPECT_TRUE(a == b);
  b.add(7, 7, 1);
  EXPECT_FALSE(a == b);
  EXPECT_FALSE(a == EvidenceGrid(GridGeometry{0.2}));
}

TEST(GridGeometry, ACellsCentreLiesInThatCell) {
  for (const double cell_size : {0.05, kDefaultCellSize, 1.0}) {
    const GridGeometry geometry{cell_size};
    for (int i = -5; i < kGridSize + 5; ++i) {
      EXPECT_EQ(geometry.index(geometry.centre(i)), i);
      EXPECT_EQ(geometry.index(geometry.centre(i) - 0.499 * cell_size), i);
      EXPECT_EQ(geometry.index(geometry.centre(i) + 0.499 * cell_size), i);
    }
  }
}

TEST(GridGeometry, TheOriginIsTheCornerOfTheFourMiddleCells) {
  const GridGeometry geometry{0.5};
  EXPECT_DOUBLE_EQ(geometry.centre(31), -0.25);
  EXPECT_DOUBLE_EQ(geometry.centre(32), 0.25);
  EXPECT_DOUBLE_EQ(geometry.halfWidth(), 16.0);
  EXPECT_EQ(geometry.index(-15.99), 0);
  EXPECT_EQ(geometry.index(15.99), 63);
  EXPECT_EQ(geometry.index(-16.01), -1);
  EXPECT_EQ(geometry.index(16.01), 64);
}

}  // namespace
}  // namespace place_memory::core
