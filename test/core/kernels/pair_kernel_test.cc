#include "core/kernels/pair_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <iostream>
#include <random>

namespace place_memory::core {
namespace {

using Rows = std::array<std::uint64_t, 64>;

Rows randomRows(std::mt19937_64& engine, int kind) {
  Rows rows{};
  for (std::uint64_t& row : rows) {
    if (kind == 0) row = engine();
    if (kind == 1) row = ~std::uint64_t{0};
    if (kind == 2) row = engine() & engine() & engine();
  }
  return rows;
}

std::uint64_t cells(std::uint64_t row) { return std::bitset<64>(row).count(); }

std::array<std::uint64_t, 6> asArray(const PlaneCounts& n) {
  return {n.occupied,       n.empty,          n.occupied_occupied,
          n.occupied_empty, n.empty_occupied, n.empty_empty};
}

std::array<std::uint64_t, 6> naiveCounts(const RowPairs& pairs) {
  std::array<std::uint64_t, 6> n{};
  for (int row = 0; row < pairs.rows; ++row) {
    const auto moved = [&](std::uint64_t cells) {
      return pairs.columns >= 0 ? cells << pairs.columns : cells >> -pairs.columns;
    };
    const std::uint64_t o = moved(pairs.occupied[row]), e = moved(pairs.empty[row]);
    n[0] += cells(o);
    n[1] += cells(e);
    n[2] += cells(o & pairs.learned_occupied[row]);
    n[3] += cells(o & pairs.learned_empty[row]);
    n[4] += cells(e & pairs.learned_occupied[row]);
    n[5] += cells(e & pairs.learned_empty[row]);
  }
  return n;
}

TEST(PairKernels, AllCountWhatIsThere) {
  std::mt19937_64 engine(4);
  const auto& sets = instructionSets();
  for (const auto& variant : pairKernels()) {
    if (std::count(sets.begin(), sets.end(), variant.set) == 0) {
      std::cout << nameOf(variant.set) << ": not on this processor\n";
      continue;
    }
    for (const int kind : {0, 1, 2, 3}) {
      const Rows o = randomRows(engine, kind), e = randomRows(engine, kind);
      const Rows lo = randomRows(engine, kind), le = randomRows(engine, kind);
      for (const int rows : {64, 63, 56, 55, 9, 8, 7, 1}) {
        const int first = 64 - rows;
        for (const int columns : {0, 1, -1, 8, -8, 31, -31, 63, -63}) {
          const RowPairs pairs{o.data(), e.data() + first, lo.data() + first, le.data(),
                               rows,     columns};
          EXPECT_EQ(asArray(variant.kernel(pairs)), naiveCounts(pairs))
              << nameOf(variant.set) << ", " << rows << " rows, " << columns << " columns";
        }
      }
    }
  }
}

}  // namespace
}  // namespace place_memory::core
