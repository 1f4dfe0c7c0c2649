#include "core/kernels/coarse_planes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "core/match/query_planes.h"

namespace place_memory::core {
namespace {

/// Cells that are drawn with these shares, in patches so that coarse cells differ.
CellPlanes randomCells(std::mt19937& engine) {
  CellPlanes cells;
  for (std::size_t row = 0; row < kGridSize; ++row) {
    for (unsigned column = 0; column < kGridSize; ++column) {
      const unsigned patch = (static_cast<unsigned>(row) / 8 + column / 8) % 4;
      const unsigned drawn = static_cast<unsigned>(engine()) % 8;
      if (drawn < patch) {
        cells.occupied[row] |= std::uint64_t{1} << column;
      } else if (drawn < 4 + patch) {
        cells.empty[row] |= std::uint64_t{1} << column;
      }
    }
  }
  return cells;
}

CellPlanes filledWith(std::uint64_t occupied, std::uint64_t empty) {
  CellPlanes cells;
  cells.occupied.fill(occupied);
  cells.empty.fill(empty);
  return cells;
}

std::vector<CellPlanes> samples() {
  std::mt19937 engine(41);
  std::vector<CellPlanes> all{filledWith(0, 0), filledWith(~std::uint64_t{0}, 0),
                              filledWith(0, ~std::uint64_t{0}),
                              filledWith(0x8000000000000001, 0x7ffffffffffffffe)};
  for (int i = 0; i < 20; ++i) all.push_back(randomCells(engine));
  return all;
}

int countSet(const BitPlane& plane, std::size_t row, std::size_t column, std::size_t side) {
  int set = 0;
  for (std::size_t r = row; r < row + side; ++r) {
    for (std::size_t c = column; c < column + side; ++c) set += plane[r] >> c & 1 ? 1 : 0;
  }
  return set;
}

/// `side` cells along each side of a coarse one; rows that share a word alternate in its bits.
std::vector<QueryRow> naiveRows(const CellPlanes& cells, std::size_t side, int occupied_from,
                                int empty_from) {
  std::vector<QueryRow> rows(kGridSize / side / side);
  for (std::size_t row = 0; row < kGridSize / side; ++row) {
    for (std::size_t column = 0; column < kGridSize / side; ++column) {
      const std::uint64_t bit = std::uint64_t{1} << (side * column + row % side);
      if (countSet(cells.occupied, side * row, side * column, side) >= occupied_from) {
        rows[row / side].occupied |= bit;
      } else if (countSet(cells.empty, side * row, side * column, side) >= empty_from) {
        rows[row / side].empty |= bit;
      }
    }
  }
  return rows;
}

void expectSame(const QueryRow* rows, const std::vector<QueryRow>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(rows[i].occupied, expected[i].occupied) << "row " << i;
    ASSERT_EQ(rows[i].empty, expected[i].empty) << "row " << i;
  }
}

CellPlanes moved(const CellPlanes& cells, CellShift shift) {
  CellPlanes to;
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const int from_row = row - shift.rows, from_column = column - shift.columns;
      if (from_row < 0 || from_row >= kGridSize) continue;
      if (from_column < 0 || from_column >= kGridSize) continue;
      const auto r = static_cast<std::size_t>(row), from = static_cast<std::size_t>(from_row);
      to.occupied[r] |= (cells.occupied[from] >> from_column & 1) << column;
      to.empty[r] |= (cells.empty[from] >> from_column & 1) << column;
    }
  }
  return to;
}

CellTotals totalsOf(const CellPlanes& cells) {
  CellTotals totals;
  for (std::size_t row = 0; row < kGridSize; ++row) {
    for (std::size_t column = 0; column < kGridSize; ++column) {
      totals.occupied =
          static_cast<std::uint16_t>(totals.occupied + (cells.occupied[row] >> column & 1));
      totals.empty = static_cast<std::uint16_t>(totals.empty + (cells.empty[row] >> column & 1));
    }
  }
  return totals;
}

TEST(CoarsePlanes, EqualTheCountCellByCell) {
  for (const CellPlanes& cells : samples()) {
    std::vector<QueryRow> rows(kCoarsestRows);
    coarsenMost(cells, rows.data());
    expectSame(rows.data(), naiveRows(cells, 4, 2, 8));
    if (HasFatalFailure()) return;
  }
}

TEST(CoarsePlanes, ShiftedAreThoseOfTheShiftedCells) {
  const std::vector<int> by{0, 1, -1, 2, -3, 6, -9, 62, 63, -63};
  for (const CellPlanes& cells : samples()) {
    std::vector<QueryRow> rows(by.size() * by.size() * kCoarsestRows);
    std::vector<CellTotals> inside(by.size() * by.size());
    coarsenShifted(cells, by, rows.data(), inside.data());
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const CellPlanes there = moved(cells, {by[i % by.size()], by[i / by.size()]});
      expectSame(rows.data() + i * kCoarsestRows, naiveRows(there, 4, 2, 8));
      const CellTotals totals = totalsOf(there);
      ASSERT_EQ(inside[i].occupied, totals.occupied) << i;
      ASSERT_EQ(inside[i].empty, totals.empty) << i;
    }
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace place_memory::core
