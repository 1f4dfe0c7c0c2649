#include "core/index/place_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace place_memory::core {
namespace {

using Oracle = std::map<PlaceId, CellPlanes>;

EvidenceGrid gridOf(std::mt19937& engine) {
  EvidenceGrid grid;
  for (int i = 0; i < 50; ++i) {
    const unsigned at = static_cast<unsigned>(engine()) % kGridCells;
    grid.cells()[at] = engine() % 2 == 0 ? std::int8_t{5} : std::int8_t{-5};
  }
  return grid;
}

/// Puts a random place into both.
void put(PlaceId id, std::mt19937& engine, PlaceIndex& index, Oracle& oracle) {
  const EvidenceGrid grid = gridOf(engine);
  index.put(id, grid);
  oracle[id] = CellPlanes(grid);
}

void expectSame(const PlaceIndex& index, const Oracle& oracle) {
  ASSERT_EQ(index.size(), oracle.size());
  auto expected = oracle.begin();
  for (const auto& block : index.blocks()) {
    ASSERT_NE(block, nullptr);
    ASSERT_GE(block->size(), 1U);
    ASSERT_LE(block->size(), PlaceIndex::kBlockSize);
    for (std::size_t slot = 0; slot < block->size(); ++slot) {
      const CellPlanes cells = block->planes().get(slot);
      ASSERT_NE(expected, oracle.end());
      ASSERT_EQ((*block)[slot], expected->first);
      ASSERT_EQ(cells.occupied, expected->second.occupied);
      ASSERT_EQ(cells.empty, expected->second.empty);
      ++expected;
    }
  }
  ASSERT_EQ(expected, oracle.end());
}

TEST(PlaceIndex, StartsEmpty) {
  PlaceIndex index;
  expectSame(index, {});
  EXPECT_FALSE(index.erase(1));
  EXPECT_TRUE(index.blocks().empty());
}

TEST(PlaceIndex, TakesIdsInAnyOrder) {
  std::mt19937 engine(21);
  std::vector<PlaceId> rising(300);
  for (std::size_t i = 0; i < rising.size(); ++i) rising[i] = static_cast<PlaceId>(i + 1);
  std::vector<PlaceId> falling(rising.rbegin(), rising.rend());
  std::vector<PlaceId> shuffled = rising;
  std::shuffle(shuffled.begin(), shuffled.end(), engine);
  for (const auto& ids : {rising, falling, shuffled}) {
    PlaceIndex index;
    Oracle oracle;
    for (const PlaceId id : ids) {
      put(id, engine, index, oracle);
      expectSame(index, oracle);
      if (HasFatalFailure()) FAIL() << "after id " << id;
    }
  }
}

TEST(PlaceIndex, TakesTheLargestIds) {
  std::mt19937 engine(22);
  PlaceIndex index;
  Oracle oracle;
  for (const PlaceId id : {std::numeric_limits<PlaceId>::max(), PlaceId{1}, PlaceId{1} << 40}) {
    put(id, engine, index, oracle);
    expectSame(index, oracle);
  }
  EXPECT_TRUE(index.erase(std::numeric_limits<PlaceId>::max()));
}

TEST(PlaceIndex, RisingIdsFillTheirBlocks) {
  std::mt19937 engine(23);
  PlaceIndex index;
  Oracle oracle;
  for (PlaceId id = 1; id <= 3 * static_cast<PlaceId>(PlaceIndex::kBlockSize); ++id) {
    put(id, engine, index, oracle);
  }
  EXPECT_EQ(index.blocks().size(), 3U);
}

TEST(PlaceIndex, TellsTheCellsOfAPlace) {
  std::mt19937 engine(26);
  PlaceIndex index;
  Oracle oracle;
  for (PlaceId id = 1; id <= 40; id += 3) put(id, engine, index, oracle);
  for (const auto& [id, kept] : oracle) {
    EXPECT_EQ(index.cells(id).occupied, kept.occupied);
    EXPECT_EQ(index.cells(id).empty, kept.empty);
  }
  for (const PlaceId id : {0, 2, 39, 41}) EXPECT_THROW(index.cells(id), std::out_of_range) << id;
}

TEST(PlaceIndex, BlocksThatErasingEmptiedAreJoined) {
  std::mt19937 engine(27);
  PlaceIndex index;
  Oracle oracle;
  for (PlaceId id = 1; id <= 640; ++id) put(id, engine, index, oracle);
  for (PlaceId id = 1; id <= 640; ++id) {
    if (id % 8 == 0) continue;
    index.erase(id);
    oracle.erase(id);
  }
  expectSame(index, oracle);
  EXPECT_LE(index.blocks().size(), 2 * 80 / PlaceIndex::kBlockSize);
}

TEST(PlaceIndex, EraseTellsWhetherThePlaceWasThere) {
  std::mt19937 engine(24);
  PlaceIndex index;
  Oracle oracle;
  for (const PlaceId id : {2, 4, 6}) put(id, engine, index, oracle);
  for (const PlaceId id : {1, 3, 5, 7}) EXPECT_FALSE(index.erase(id)) << id;
  expectSame(index, oracle);
  EXPECT_TRUE(index.erase(4));
  EXPECT_FALSE(index.erase(4));
  oracle.erase(4);
  expectSame(index, oracle);
}

TEST(PlaceIndex, ClearLeavesNothingAndTheIndexUsable) {
  std::mt19937 engine(25);
  PlaceIndex index;
  Oracle oracle;
  for (PlaceId id = 1; id <= 100; ++id) put(id, engine, index, oracle);
  index.clear();
  expectSame(index, {});
  oracle.clear();
  put(7, engine, index, oracle);
  expectSame(index, oracle);
}

TEST(PlaceIndex, FollowsAnySequenceOfChanges) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 engine(seed);
    std::uniform_int_distribution<PlaceId> id(1, 400);
    PlaceIndex index;
    Oracle oracle;
    for (int i = 0; i < 3000; ++i) {
      // Grows, then shrinks to little, and so on.
      const bool grows = (i / 600) % 2 == 0;
      const PlaceId any = id(engine);
      if (engine() % 4 != 0 ? grows : !grows) {
        put(any, engine, index, oracle);
      } else {
        ASSERT_EQ(index.erase(any), oracle.erase(any) == 1) << "seed " << seed << ", step " << i;
      }
      ASSERT_EQ(index.size(), oracle.size());
      if (i % 20 == 0) expectSame(index, oracle);
      if (HasFatalFailure()) FAIL() << "seed " << seed << ", step " << i;
    }
    expectSame(index, oracle);
  }
}

TEST(PlaceIndex, ACopyKeepsWhatTheIndexHeldWhenItWasMade) {
  std::mt19937 engine(31);
  std::uniform_int_distribution<PlaceId> id(1, 300);
  PlaceIndex index;
  Oracle oracle;
  std::vector<std::pair<PlaceIndex, Oracle>> snapshots;
  for (int i = 0; i < 1500; ++i) {
    const PlaceId any = id(engine);
    if (engine() % 3 != 0) {
      put(any, engine, index, oracle);
    } else {
      index.erase(any);
      oracle.erase(any);
    }
    if (i % 75 == 0) snapshots.emplace_back(index, oracle);
  }
  index.clear();
  for (const auto& [snapshot, then] : snapshots) expectSame(snapshot, then);
}

TEST(PlaceIndex, ChangesOfACopyLeaveTheOriginalAlone) {
  std::mt19937 engine(32);
  PlaceIndex index;
  Oracle oracle;
  for (PlaceId id = 1; id <= 130; ++id) put(id, engine, index, oracle);
  PlaceIndex copy = index;
  Oracle changed = oracle;
  put(50, engine, copy, changed);
  put(500, engine, copy, changed);
  copy.erase(1);
  changed.erase(1);
  expectSame(index, oracle);
  expectSame(copy, changed);
}

TEST(PlaceIndex, ACopySharesItsBlocksUntilTheyChange) {
  std::mt19937 engine(33);
  PlaceIndex index;
  Oracle oracle;
  for (PlaceId id = 1; id <= 200; ++id) put(id, engine, index, oracle);
  const PlaceIndex copy = index;
  ASSERT_EQ(copy.blocks(), index.blocks());
  put(3, engine, index, oracle);  // in the first block
  EXPECT_NE(copy.blocks().front(), index.blocks().front());
  EXPECT_EQ(copy.blocks().back(), index.blocks().back());
}

TEST(PlaceIndex, WhatNoCopySharesIsChangedWhereItLies) {
  std::mt19937 engine(9);
  PlaceIndex index;
  Oracle oracle;
  put(1, engine, index, oracle);
  const PlaceBlock* const block = index.blocks().front().get();
  {
    const PlaceIndex copy = index;
    put(2, engine, index, oracle);
    EXPECT_NE(index.blocks().front().get(), block);
  }
  const PlaceBlock* const own = index.blocks().front().get();
  put(3, engine, index, oracle);
  put(1, engine, index, oracle);
  index.erase(2);
  oracle.erase(2);
  EXPECT_EQ(index.blocks().front().get(), own);
  expectSame(index, oracle);
}

}  // namespace
}  // namespace place_memory::core
