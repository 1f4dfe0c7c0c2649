#include "core/recognize/rescoring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace place_memory::core {
namespace {

CellPlanes randomCells(unsigned seed) {
  std::mt19937 engine(seed);
  CellPlanes cells;
  for (std::size_t row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const auto draw = engine() % 8;
      if (draw == 0) cells.occupied[row] |= std::uint64_t{1} << column;
      if (draw > 4) cells.empty[row] |= std::uint64_t{1} << column;
    }
  }
  return cells;
}

/// The class of a cell, unsensed outside the grid.
CellClass classAt(const CellPlanes& cells, int row, int column) {
  if (row < 0 || row >= kGridSize || column < 0 || column >= kGridSize) return CellClass::kUnsensed;
  const auto r = static_cast<std::size_t>(row);
  if ((cells.occupied[r] >> column & 1) != 0) return CellClass::kOccupied;
  return (cells.empty[r] >> column & 1) != 0 ? CellClass::kEmpty : CellClass::kUnsensed;
}

/// Whether a cell of the learned grid's frame has an occupied one within so many cells. Cells that
/// the shift moves out of the frame are gone.
bool nearOccupied(const CellPlanes& cells, CellShift shift, int row, int column, int within) {
  for (int r = row - within; r <= row + within; ++r) {
    for (int c = column - within; c <= column + within; ++c) {
      if (r < 0 || r >= kGridSize || c < 0 || c >= kGridSize) continue;
      if (classAt(cells, r - shift.rows, c - shift.columns) == CellClass::kOccupied) return true;
    }
  }
  return false;
}

/// Cell by cell.
RescoringCounts naiveCounts(const CellPlanes& scan, CellShift shift, const CellPlanes& learned) {
  RescoringCounts counts;
  const auto count = [&](NearPairs cells, bool holds) {
    counts.near[static_cast<std::size_t>(cells)] += holds ? 1 : 0;
  };
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const CellClass r = classAt(scan, row - shift.rows, column - shift.columns);
      const CellClass l = classAt(learned, row, column);
      const double distance = std::hypot(row - 31.5, column - 31.5);
      auto& ring = distance <= 9.0 ? counts.inner : counts.middle;
      if (distance <= 17.0) ++ring[static_cast<std::size_t>(r)][static_cast<std::size_t>(l)];
      const bool by_learned = nearOccupied(learned, {}, row, column, 1);
      const bool by_scan = nearOccupied(scan, shift, row, column, 1);
      const bool occupied = r == CellClass::kOccupied;
      const bool learned_occupied = l == CellClass::kOccupied;
      count(NearPairs::kOccupiedWithinOne, occupied && by_learned);
      count(NearPairs::kOccupiedWithinTwo, occupied && nearOccupied(learned, {}, row, column, 2));
      count(NearPairs::kLearnedOccupiedWithinOne, learned_occupied && by_scan);
      count(NearPairs::kLearnedOccupiedWithinTwo,
            learned_occupied && nearOccupied(scan, shift, row, column, 2));
      count(NearPairs::kWithinOneOfBoth, by_scan && by_learned);
      count(NearPairs::kEmptyByOccupied, r == CellClass::kEmpty && by_learned);
      count(NearPairs::kOccupiedByEmpty, l == CellClass::kEmpty && by_scan);
    }
  }
  return counts;
}

TEST(CountForRescoring, EqualsTheCountCellByCell) {
  const CellPlanes scan = randomCells(1), learned = randomCells(2);
  for (const CellShift shift :
       {CellShift{0, 0}, {3, -2}, {-9, 9}, {63, 0}, {0, -63}, {-31, 32}, {1, 1}}) {
    const RescoringCounts found = countForRescoring(scan, shift, learned);
    const RescoringCounts expected = naiveCounts(scan, shift, learned);
    EXPECT_EQ(found.inner, expected.inner) << shift.columns << ", " << shift.rows;
    EXPECT_EQ(found.middle, expected.middle) << shift.columns << ", " << shift.rows;
    EXPECT_EQ(found.near, expected.near) << shift.columns << ", " << shift.rows;
  }
}

TEST(Rescore, WeighsTheSearchScoreThePairsTheNearPairsAndThePeaksSharpness) {
  RescoringCounts counts;
  counts.inner[2][2] = 7;
  counts.middle[0][1] = 3;
  counts.near[5] = 11;
  RescoringWeights weights;
  weights.search_score = 0.5;
  weights.inner[2][2] = 2.0;
  weights.middle[0][1] = 4.0;
  weights.near[5] = -1.0;
  weights.peak_sharpness_shift = -0.5;
  weights.peak_sharpness_rotation = -2.0;
  EXPECT_DOUBLE_EQ(rescore(10.0, counts, {-6.0, -5.0}, weights),
                   5.0 + 14.0 + 12.0 - 11.0 + 3.0 + 10.0);
}

TEST(CombineScores, ThoseNotRescoredKeepTheirDistanceToTheLast) {
  EXPECT_EQ(combineScores({9.0, 8.0, 6.0, 5.0}, {1.0, 4.0}),
            (std::vector<double>{1.0, 4.0, -1.0, -2.0}));
}

TEST(CombineScores, WhereAllWereRescoredNothingIsLeft) {
  EXPECT_EQ(combineScores({9.0, 8.0}, {1.0, 4.0}), (std::vector<double>{1.0, 4.0}));
}

}  // namespace
}  // namespace place_memory::core
