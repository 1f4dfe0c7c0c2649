#include "core/store/place_store.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

TEST_F(PlaceStoreTest, GivesBackWhatWasAdded) {
  PlaceStore store("", kDefaultCellSize);
  const PlaceId a = store.add(makePlace("a"), makeGrid(1), kNoPlace);
  const PlaceId b = store.add(makePlace("b"), makeGrid(2), a);
  const PlaceMap map = store.map();
  ASSERT_EQ(map.size(), 2U);
  const Place& place = *map.find(a);
  EXPECT_EQ(place.label, "a");
  EXPECT_EQ(place.map_from_place.x, 1.25);
  EXPECT_EQ(place.map_from_place.y, -7.5);
  EXPECT_EQ(place.map_from_place.yaw, 0.3);
  EXPECT_EQ(place.learned.count(), 1234567890123456789);
  ASSERT_EQ(map.links().size(), 1U);
  EXPECT_NE(map.findLink(a, b), nullptr);
  EXPECT_EQ(store.grid(a), makeGrid(1));
  EXPECT_EQ(store.grid(b), makeGrid(2));
  EXPECT_THROW(store.grid(99), StoreError);
}

TEST_F(PlaceStoreTest, ReadsEveryGridInTheOrderOfIds) {
  fill();
  std::vector<PlaceId> ids;
  open().forEachGrid([&ids](PlaceId id, const EvidenceGrid& grid) {
    ids.push_back(id);
    EXPECT_EQ(grid, makeGrid(static_cast<unsigned>(ids.size())));
  });
  EXPECT_EQ(ids, (std::vector<PlaceId>{1, 2, 3}));
}

TEST_F(PlaceStoreTest, ReadsThePlanesOfEveryGridAsItIsNow) {
  fill();
  PlaceStore store = open();
  store.update(3, makeGrid(7));
  store.remove(1);
  std::vector<PlaceId> ids;
  store.forEachPlanes([&](PlaceId id, const CellPlanes& planes) {
    ids.push_back(id);
    const CellPlanes expected(store.grid(id));
    EXPECT_EQ(planes.occupied, expected.occupied);
    EXPECT_EQ(planes.empty, expected.empty);
  });
  EXPECT_EQ(ids, (std::vector<PlaceId>{2, 3}));
}

TEST_F(PlaceStoreTest, MakesManyChangesAtOnce) {
  PlaceStore store = open();
  store.atOnce([&store] {
    store.add(makePlace("a"), makeGrid(1), kNoPlace);
    store.add(makePlace("b"), makeGrid(2), 1);
    store.rename(1, "z");
  });
  EXPECT_EQ(store.map().find(1)->label, "z");
  EXPECT_EQ(store.map().links().size(), 1U);
}

TEST_F(PlaceStoreTest, UndoesAllOfTheChangesAtOnceWhereOneFails) {
  fill();
  PlaceStore store = open();
  const auto changes = [&store] {
    store.remove(1);
    store.add(makePlace("d"), makeGrid(4), kNoPlace);
    store.rename(2, "c");  // which another place is called
  };
  EXPECT_THROW(store.atOnce(changes), StoreError);
  EXPECT_EQ(store.map().size(), 3U);
  EXPECT_EQ(store.grid(1), makeGrid(1));
  EXPECT_NO_THROW(store.rename(1, "z"));
}

TEST_F(PlaceStoreTest, RenamesRemovesAndClears) {
  fill();
  PlaceStore store = open();
  store.rename(1, "z");
  store.remove(2);
  PlaceMap map = store.map();
  EXPECT_EQ(map.size(), 2U);
  EXPECT_EQ(map.find("z")->id, 1);
  EXPECT_TRUE(map.links().empty());
  EXPECT_THROW(store.grid(2), StoreError);
  store.clear();
  EXPECT_EQ(store.map().size(), 0U);
  EXPECT_THROW(store.grid(1), StoreError);
}

TEST_F(PlaceStoreTest, PutsAnotherGridInThePlaceOfTheOneAPlaceHas) {
  fill();
  {
    PlaceStore store = open();
    store.update(2, makeGrid(7));
    EXPECT_THROW(store.update(99, makeGrid(8)), StoreError);
  }
  const PlaceStore store = open();
  EXPECT_EQ(store.grid(1), makeGrid(1));
  EXPECT_EQ(store.grid(2), makeGrid(7));
  EXPECT_EQ(store.map().size(), 3U);
}

TEST_F(PlaceStoreTest, AGridThatCannotBeUpdatedStays) {
  fill();
  runSql(path_, "CREATE TRIGGER full AFTER UPDATE ON grid BEGIN SELECT RAISE(ABORT, 'full'); END");
  PlaceStore store = open();
  EXPECT_THROW(store.update(2, makeGrid(7)), StoreError);
  EXPECT_EQ(store.grid(2), makeGrid(2));
}

TEST_F(PlaceStoreTest, NeverGivesAnIdAgain) {
  fill();
  {
    PlaceStore store = open();
    store.remove(3);
    EXPECT_EQ(store.add(makePlace("d"), makeGrid(4), kNoPlace), 4);
    store.clear();
  }
  EXPECT_EQ(open().add(makePlace("e"), makeGrid(5), kNoPlace), 5);
}

TEST_F(PlaceStoreTest, EveryChangeIsInTheFileWhenTheCallReturns) {
  PlaceStore store = open();
  const std::string copy = folder_.file("copy.db");
  const auto expect_in_file = [&](const std::vector<std::string>& labels) {
    fs::copy_file(path_, copy, fs::copy_options::overwrite_existing);
    std::vector<std::string> found;
    const PlaceMap map = PlaceStore(copy, kDefaultCellSize).map();
    for (const Place& place : map.places()) {
      found.push_back(place.label);
    }
    EXPECT_EQ(found, labels);
  };
  store.add(makePlace("a"), makeGrid(1), kNoPlace);
  expect_in_file({"a"});
  store.add(makePlace("b"), makeGrid(2), 1);
  expect_in_file({"a", "b"});
  store.rename(1, "z");
  expect_in_file({"z", "b"});
  store.remove(1);
  expect_in_file({"b"});
  store.clear();
  expect_in_file({});
}

TEST_F(PlaceStoreTest, AChangeThatFailsHalfWayLeavesNothing) {
  fill();
  runSql(path_, "CREATE TRIGGER full BEFORE INSERT ON link BEGIN SELECT RAISE(ABORT, 'full'); END");
  PlaceStore store = open();
  EXPECT_THROW(store.add(makePlace("d"), makeGrid(4), 1), StoreError);
  EXPECT_EQ(store.map().size(), 3U);
  EXPECT_THROW(store.grid(4), StoreError);
  EXPECT_NO_THROW(store.add(makePlace("d"), makeGrid(4), kNoPlace));
}

TEST_F(PlaceStoreTest, RefusesALabelTwice) {
  fill();
  PlaceStore store = open();
  EXPECT_THROW(store.add(makePlace("a"), makeGrid(4), kNoPlace), StoreError);
  EXPECT_THROW(store.rename(1, "b"), StoreError);
  EXPECT_EQ(store.map().size(), 3U);
}

TEST_F(PlaceStoreTest, TakesACellSizeThatWentThroughText) {
  fill();
  EXPECT_NO_THROW(PlaceStore(path_, 0.142875));
}

TEST_F(PlaceStoreTest, TakesAStoreOfFormat1) {
  fill();
  runSql(path_, kToFormat1);
  for (int opening = 0; opening < 2; ++opening) {
    const PlaceStore store = open();
    EXPECT_EQ(store.map().links().size(), 2U);
    std::size_t places = 0;
    store.forEachPlanes([&](PlaceId id, const CellPlanes& planes) {
      EXPECT_EQ(planes.occupied, CellPlanes(makeGrid(static_cast<unsigned>(id))).occupied);
      ++places;
    });
    EXPECT_EQ(places, 3U);
  }
}

}  // namespace
}  // namespace place_memory::core
