#include "core/kernels/transform_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <random>
#include <vector>

namespace place_memory::core {
namespace {

CellPlanes cellsOf(std::mt19937_64& engine, int kind) {
  CellPlanes cells;
  for (std::size_t row = 0; row < kGridSize; ++row) {
    if (kind == 0) cells.occupied[row] = engine(), cells.empty[row] = engine();
    if (kind == 1) cells.occupied[row] = ~std::uint64_t{0};
    if (kind == 2) cells.empty[row] = ~std::uint64_t{0};
    if (kind == 3) cells.occupied[row] = cells.empty[row] = ~std::uint64_t{0};
  }
  return cells;
}

bool isSet(const BitPlane& plane, int row, int column) {
  if (row < 0 || row >= kGridSize || column < 0 || column >= kGridSize) return false;
  return (plane[static_cast<std::size_t>(row)] >> column & 1) != 0;
}

std::array<std::uint64_t, 6> asArray(const PlaneCounts& n) {
  return {n.occupied,       n.empty,          n.occupied_occupied,
          n.occupied_empty, n.empty_occupied, n.empty_empty};
}

/// Cell by cell.
std::array<std::uint64_t, 6> naiveCounts(const CellPlanes& learned, const MovedPlanes& moved) {
  std::array<std::uint64_t, 6> n{};
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const int from_row = row - moved.shift.rows, from_column = column - moved.shift.columns;
      const bool o = isSet(moved.cells->occupied, from_row, from_column);
      const bool e = isSet(moved.cells->empty, from_row, from_column);
      const bool lo = isSet(learned.occupied, row, column);
      const bool le = isSet(learned.empty, row, column);
      const bool found[] = {o, e, o && lo, o && le, e && lo, e && le};
      for (std::size_t i = 0; i < n.size(); ++i) n[i] += found[i] ? 1 : 0;
    }
  }
  return n;
}

TEST(TransformKernels, AllCountWhatIsThere) {
  std::mt19937_64 engine(5);
  std::vector<CellPlanes> grids;
  for (const int kind : {0, 1, 2, 3, 4, 0}) grids.push_back(cellsOf(engine, kind));
  std::vector<MovedPlanes> transforms;
  for (const CellPlanes& cells : grids) {
    for (const int rows : {0, 1, -1, 8, -9, 63, -63}) {
      for (const int columns : {0, 1, -1, 31, -8, 63, -63}) {
        transforms.push_back({&cells, {columns, rows}});
      }
    }
  }
  const auto& sets = instructionSets();
  for (const auto& variant : transformKernels()) {
    if (std::count(sets.begin(), sets.end(), variant.set) == 0) {
      std::cout << nameOf(variant.set) << ": not on this processor\n";
      continue;
    }
    for (const CellPlanes& learned : grids) {
      std::vector<PlaneCounts> counts(transforms.size());
      variant.kernel(learned, transforms.data(), transforms.size(), counts.data());
      for (std::size_t i = 0; i < transforms.size(); ++i) {
        ASSERT_EQ(asArray(counts[i]), naiveCounts(learned, transforms[i]))
            << nameOf(variant.set) << ", " << transforms[i].shift.columns << " columns, "
            << transforms[i].shift.rows << " rows";
      }
    }
  }
}

}  // namespace
}  // namespace place_memory::core
