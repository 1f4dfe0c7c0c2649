#include "core/match/query_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/match/lattice.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

struct NamedGrid {
  std::string name;
  EvidenceGrid grid;
};

NamedGrid gridFrom(const std::string& name, const std::function<int(int row, int column)>& cell) {
  NamedGrid named{name, EvidenceGrid()};
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column)
      named.grid.add(row, column, cell(row, column));
  }
  return named;
}

NamedGrid randomGrid(unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> evidence(-2, 2);
  return gridFrom("random " + std::to_string(seed),
                  [&](int, int) { return evidence(engine) * (engine() % 2 == 0 ? 1 : 60); });
}

NamedGrid singleCell(int at_row, int at_column, int evidence) {
  return gridFrom(
      "single " + std::to_string(at_row) + "," + std::to_string(at_column),
      [=](int row, int column) { return row == at_row && column == at_column ? evidence : 0; });
}

std::vector<NamedGrid> grids() {
  return {randomGrid(1),
          randomGrid(2),
          gridFrom("unsensed", [](int, int) { return 0; }),
          gridFrom("occupied", [](int, int) { return 127; }),
          gridFrom("empty", [](int, int) { return -1; }),
          gridFrom("checkerboard", [](int r, int c) { return (r + c) % 2 == 0 ? 1 : -1; }),
          singleCell(0, 0, 1),
          singleCell(63, 0, -127),
          singleCell(0, 63, 127),
          singleCell(63, 63, -1),
          singleCell(20, 41, 5)};
}

bool bit(const BitPlane& plane, int row, int column) {
  return (plane[static_cast<std::size_t>(row)] >> column & 1) != 0;
}

/// Class of a cell of a plane pair; a cell may not be both.
CellClass classOf(const CellPlanes& planes, int row, int column) {
  const bool occupied = bit(planes.occupied, row, column);
  const bool empty = bit(planes.empty, row, column);
  EXPECT_FALSE(occupied && empty) << row << ", " << column;
  if (occupied) return CellClass::kOccupied;
  return empty ? CellClass::kEmpty : CellClass::kUnsensed;
}

CellClass classOf(int evidence) {
  if (evidence > 0) return CellClass::kOccupied;
  return evidence < 0 ? CellClass::kEmpty : CellClass::kUnsensed;
}

constexpr CellClass kClasses[] = {CellClass::kEmpty, CellClass::kUnsensed, CellClass::kOccupied};
static_assert(kCellClasses == 3, "the oracle counts three classes");

/// One pair after the other: each learned cell, and the cell of the rotated grid that falls on it.
PairCounts naiveCounts(const CellPlanes& recognition, CellShift shift,
                       const EvidenceGrid& learned) {
  PairCounts counts{};
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const int from_row = row - shift.rows;
      const int from_column = column - shift.columns;
      const bool reached =
          from_row >= 0 && from_row < kGridSize && from_column >= 0 && from_column < kGridSize;
      const CellClass falls_on =
          reached ? classOf(recognition, from_row, from_column) : CellClass::kUnsensed;
      const auto l = static_cast<std::size_t>(classOf(learned.at(row, column)));
      ++counts[static_cast<std::size_t>(falls_on)][l];
    }
  }
  return counts;
}

std::vector<CellShift> sampledShifts() {
  std::vector<CellShift> shifts;
  for (const int rows : {-63, -32, -1, 0, 1, 31, 63}) {
    for (const int columns : {-63, -33, -1, 0, 1, 32, 63}) shifts.push_back({columns, rows});
  }
  std::mt19937 engine(3);
  std::uniform_int_distribution<int> cells(-63, 63);
  for (int i = 0; i < 12; ++i) shifts.push_back({cells(engine), cells(engine)});
  return shifts;
}

TEST(CellPlanes, ClassesFollowTheSignOfTheEvidence) {
  for (const NamedGrid& named : grids()) {
    const CellPlanes planes(named.grid);
    for (int row = 0; row < kGridSize; ++row) {
      for (int column = 0; column < kGridSize; ++column) {
        ASSERT_EQ(classOf(planes, row, column), classOf(named.grid.at(row, column))) << named.name;
      }
    }
  }
}

TEST(Turned, NoRotationChangesNothing) {
  for (const NamedGrid& named : grids()) {
    const CellPlanes planes(named.grid);
    const CellPlanes cells = rotated(planes, 0.0);
    EXPECT_EQ(cells.occupied, planes.occupied) << named.name;
    EXPECT_EQ(cells.empty, planes.empty) << named.name;
  }
}

TEST(Turned, AQuarterRotationIsExactAndCounterClockwise) {
  const NamedGrid named = randomGrid(7);
  const CellPlanes planes(named.grid);
  const CellPlanes cells = rotated(planes, 0.5 * kPi);
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      // (x, y) goes to (-y, x): the column of a cell becomes its row.
      EXPECT_EQ(classOf(cells, column, kGridSize - 1 - row), classOf(planes, row, column));
    }
  }
}

TEST(Turned, TakeEachCellFromWhereItLayInMetres) {
  const GridGeometry geometry{0.25};
  for (const NamedGrid& named : {randomGrid(4), grids()[5], singleCell(20, 41, 5)}) {
    const CellPlanes planes(named.grid);
    for (int step = -13; step <= 13; ++step) {
      const double angle = 0.2417 * step;
      const CellPlanes cells = rotated(planes, angle);
      for (int row = 0; row < kGridSize; ++row) {
        for (int column = 0; column < kGridSize; ++column) {
          const Pose2d at{geometry.centre(column), geometry.centre(row), 0.0};
          const Pose2d was = Pose2d{0.0, 0.0, angle}.inverse() * at;
          const int from_row = geometry.index(was.y);
          const int from_column = geometry.index(was.x);
          const bool inside =
              from_row >= 0 && from_row < kGridSize && from_column >= 0 && from_column < kGridSize;
          ASSERT_EQ(classOf(cells, row, column),
                    inside ? classOf(planes, from_row, from_column) : CellClass::kUnsensed)
              << named.name << ", " << angle << " rad, " << row << ", " << column;
        }
      }
    }
  }
}

TEST(CountPairs, EqualsTheCountCellByCell) {
  const std::vector<NamedGrid> all = grids();
  const std::vector<CellShift> shifts = sampledShifts();
  std::size_t first = 0;  // every grid meets every other at a third of the shifts
  for (const NamedGrid& recognition : all) {
    const CellPlanes planes(recognition.grid);
    for (const double angle : {0.0, 0.1, -0.4, 0.25 * kPi, 0.5 * kPi, 2.0, -3.1, kPi}) {
      const CellPlanes cells = rotated(planes, angle);
      for (const NamedGrid& learned : all) {
        const CellPlanes learned_planes(learned.grid);
        first = (first + 1) % 3;
        for (std::size_t i = first; i < shifts.size(); i += 3) {
          const PairCounts counts = countPairs(cells, shifts[i], learned_planes);
          ASSERT_EQ(counts, naiveCounts(cells, shifts[i], learned.grid))
              << recognition.name << " on " << learned.name << ", " << angle << " rad, "
              << shifts[i].columns << " columns, " << shifts[i].rows << " rows";
        }
      }
    }
  }
}

TEST(CountPairs, EveryShiftOfRandomGrids) {
  const NamedGrid learned = randomGrid(9);
  const CellPlanes learned_planes(learned.grid);
  const CellPlanes cells = rotated(CellPlanes(randomGrid(8).grid), 0.3);
  for (int rows = -63; rows <= 63; rows += 6) {
    for (int columns = -63; columns <= 63; ++columns) {
      const CellShift shift{columns, rows};
      ASSERT_EQ(countPairs(cells, shift, learned_planes), naiveCounts(cells, shift, learned.grid))
          << columns << " columns, " << rows << " rows";
    }
  }
}

TEST(CountPairs, EachPairOfClassesHasItsPlace) {
  for (const CellClass recognition : kClasses) {
    for (const CellClass learned : kClasses) {
      const auto evidence = [](CellClass c) { return static_cast<int>(c) - 1; };
      const NamedGrid a = gridFrom("a", [&](int, int) { return evidence(recognition); });
      const NamedGrid b = gridFrom("b", [&](int, int) { return evidence(learned); });
      const PairCounts counts = countPairs(CellPlanes(a.grid), {1, -2}, CellPlanes(b.grid));
      PairCounts expected{};
      constexpr auto kUnsensed = static_cast<std::size_t>(CellClass::kUnsensed);
      const auto l = static_cast<std::size_t>(learned);
      expected[static_cast<std::size_t>(recognition)][l] += 63 * 62;
      expected[kUnsensed][l] += 64 * 64 - 63 * 62;
      EXPECT_EQ(counts, expected);
    }
  }
}

TEST(CountOverlap, EqualsTheCountCellByCellWhereTheGridsOverlap) {
  const NamedGrid recognition = randomGrid(8), learned = randomGrid(9);
  const QueryPlanes query(recognition.grid, 0.1, 9);
  const CellPlanes learned_planes(learned.grid);
  for (const int rotation : {-9, -4, 0, 1, 7}) {
    const BitPlane reach = query.reach(rotation);
    for (const CellShift shift : sampledShifts()) {
      PairCounts expected{};
      for (int row = 0; row < kGridSize; ++row) {
        for (int column = 0; column < kGridSize; ++column) {
          const int to_row = row + shift.rows, to_column = column + shift.columns;
          if (to_row < 0 || to_row >= kGridSize || to_column < 0 || to_column >= kGridSize)
            continue;
          if (!bit(reach, row, column)) continue;
          const auto r = static_cast<std::size_t>(classOf(query.at(rotation), row, column));
          const auto l = static_cast<std::size_t>(classOf(learned.grid.at(to_row, to_column)));
          ++expected[r][l];
        }
      }
      ASSERT_EQ(countOverlap(query.at(rotation), reach, shift, learned_planes), expected)
          << rotation << " rotations, " << shift.columns << " columns, " << shift.rows << " rows";
    }
  }
}

TEST(QueryPlanes, ReachIsWhereTheTurnedGridLies) {
  for (const double step : {3.0 * kPi / 180.0, 0.1}) {
    const QueryPlanes query(randomGrid(6).grid, step, 5);
    const GridGeometry geometry{1.0};
    for (const int rotation : {-5, 0, 2}) {
      const BitPlane reach = query.reach(rotation);
      for (int row = 0; row < kGridSize; ++row) {
        for (int column = 0; column < kGridSize; ++column) {
          const Pose2d at{geometry.centre(column), geometry.centre(row), 0.0};
          const Pose2d was = Pose2d{0.0, 0.0, rotation * step}.inverse() * at;
          const int from_row = geometry.index(was.y), from_column = geometry.index(was.x);
          const bool inside =
              from_row >= 0 && from_row < kGridSize && from_column >= 0 && from_column < kGridSize;
          ASSERT_EQ(bit(reach, row, column), inside) << rotation << ", " << row << ", " << column;
        }
      }
    }
  }
}

TEST(PairScore, ThePapersWeightsGiveAPointForEachPairOfTheSameClass) {
  EXPECT_DOUBLE_EQ(pairScore({{{5, 1, 1}, {1, 7, 1}, {1, 1, 11}}}, kPaperWeights), 23.0);
}

TEST(PairScore, EachCountHasItsOwnWeight) {
  const PairWeights weights{{{1.0, 10.0, 100.0}, {0.5, -2.0, 3.0}, {-7.0, 0.25, 1000.0}}};
  EXPECT_DOUBLE_EQ(pairScore({{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}, weights),
                   321.0 + 2.0 - 10.0 + 18.0 - 49.0 + 2.0 + 9000.0);
}

TEST(QueryPlanes, HoldTheGridAtEveryHeading) {
  const NamedGrid named = randomGrid(6);
  const QueryPlanes query(named.grid, 0.1, 7);
  EXPECT_EQ(query.rotations(), 7);
  EXPECT_DOUBLE_EQ(query.headingStep(), 0.1);
  for (int rotation = -7; rotation <= 7; ++rotation) {
    const CellPlanes expected = rotated(CellPlanes(named.grid), rotation * 0.1);
    EXPECT_EQ(query.at(rotation).occupied, expected.occupied) << rotation;
    EXPECT_EQ(query.at(rotation).empty, expected.empty) << rotation;
  }
}

TEST(QueryPlanes, HoldTheGridAtEveryHeadingStepOfASearch) {
  for (const NamedGrid& named : {randomGrid(6), randomGrid(7), grids()[5], grids()[3]}) {
    for (const int rotations : {0, 1, 14, 15, 16, 29, 30, 31, 44, 45, kHalfCircle}) {
      const QueryPlanes query(named.grid, kHeadingStep, rotations);
      for (int rotation = -rotations; rotation <= rotations; ++rotation) {
        const CellPlanes expected = rotated(CellPlanes(named.grid), rotation * kHeadingStep);
        ASSERT_EQ(query.at(rotation).occupied, expected.occupied) << named.name << ", " << rotation;
        ASSERT_EQ(query.at(rotation).empty, expected.empty) << named.name << ", " << rotation;
      }
    }
  }
}

TEST(QueryPlanes, NoRotationsHoldTheGridAsItIs) {
  const NamedGrid named = randomGrid(6);
  const QueryPlanes query(named.grid, 0.1, 0);
  EXPECT_EQ(query.rotations(), 0);
  EXPECT_EQ(query.at(0).occupied, CellPlanes(named.grid).occupied);
}

}  // namespace
}  // namespace place_memory::core
