#include "core/store/place_store.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

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
  update(store, 3, makeGrid(7));
  commit(store, {PlaceRemoved{1}});
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
  commit(store, {addition(1, makePlace("a"), makeGrid(1)), addition(2, makePlace("b"), makeGrid(2)),
                 LinkAdded{makeLink(1, 2)}, PlaceRenamed{1, "z"}});
  EXPECT_EQ(store.map().find(1)->label, "z");
  EXPECT_EQ(store.map().links().size(), 1U);
}

TEST_F(PlaceStoreTest, AddsThousandsOfPlacesAtOnce) {
  constexpr PlaceId kPlaces = 2000;
  {
    PlaceStore store = open();
    std::vector<MapEdit> edits;
    for (PlaceId id = 1; id <= kPlaces; ++id) {
      edits.emplace_back(addition(id, makePlace("place " + std::to_string(id)),
                                  makeGrid(static_cast<unsigned>(id % 50))));
      if (id > 1) edits.emplace_back(LinkAdded{makeLink(id - 1, id)});
    }
    commit(store, std::move(edits));
  }
  PlaceStore store = open();
  EXPECT_TRUE(store.setAside().empty());
  PlaceId places = 0;
  store.forEachPlanes([&](PlaceId id, const CellPlanes& planes) {
    EXPECT_EQ(id, ++places);
    EXPECT_EQ(planes.empty, CellPlanes(makeGrid(static_cast<unsigned>(id % 50))).empty);
  });
  EXPECT_EQ(places, kPlaces);
  std::vector<MapEdit> edits;
  for (PlaceId id = 2; id <= kPlaces; ++id) edits.emplace_back(PlaceRemoved{id});
  commit(store, std::move(edits));
  EXPECT_EQ(store.map().size(), 1U);
  EXPECT_TRUE(store.map().links().empty());
}

TEST_F(PlaceStoreTest, UndoesAllOfTheChangesAtOnceWhereOneFails) {
  fill();
  PlaceStore store = open();
  const PlaceMap before = store.map();
  EXPECT_THROW(commit(store, {PlaceRemoved{1}, addition(4, makePlace("d"), makeGrid(4)),
                              PlaceRenamed{2, "c"}}),  // which another place is called
               StoreError);
  EXPECT_EQ(store.map().places(), before.places());
  EXPECT_EQ(store.map().links(), before.links());
  EXPECT_EQ(store.grid(1), makeGrid(1));
  EXPECT_EQ(store.nextId(), 4);
  EXPECT_NO_THROW(rename(store, 1, "z"));
}

TEST_F(PlaceStoreTest, RenamesRemovesAndClears) {
  fill();
  PlaceStore store = open();
  rename(store, 1, "z");
  commit(store, {PlaceRemoved{2}});
  PlaceMap map = store.map();
  EXPECT_EQ(map.size(), 2U);
  EXPECT_EQ(map.find("z")->id, 1);
  EXPECT_TRUE(map.links().empty());
  EXPECT_THROW(store.grid(2), StoreError);
  commit(store, {MapCleared{}});
  EXPECT_EQ(store.map().size(), 0U);
  EXPECT_THROW(store.grid(1), StoreError);
}

TEST_F(PlaceStoreTest, PutsAnotherGridInThePlaceOfTheOneAPlaceHas) {
  fill();
  {
    PlaceStore store = open();
    update(store, 2, makeGrid(7));
    EXPECT_THROW(update(store, 99, makeGrid(8)), StoreError);
  }
  const PlaceStore store = open();
  EXPECT_EQ(store.grid(1), makeGrid(1));
  EXPECT_EQ(store.grid(2), makeGrid(7));
  EXPECT_EQ(store.map().size(), 3U);
}

TEST_F(PlaceStoreTest, AGridThatCannotBeUpdatedStays) {
  fill();
  runSql(path_, "CREATE TRIGGER full AFTER INSERT ON grid BEGIN SELECT RAISE(ABORT, 'full'); END");
  PlaceStore store = open();
  EXPECT_THROW(update(store, 2, makeGrid(7)), StoreError);
  EXPECT_EQ(store.grid(2), makeGrid(2));
}

TEST_F(PlaceStoreTest, NeverGivesAnIdAgain) {
  fill();
  {
    PlaceStore store = open();
    commit(store, {PlaceRemoved{3}});
    EXPECT_EQ(add(store, makePlace("d"), makeGrid(4), kNoPlace), 4);
    commit(store, {MapCleared{}});
  }
  EXPECT_EQ(open().nextId(), 5);
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
  add(store, makePlace("a"), makeGrid(1), kNoPlace);
  expect_in_file({"a"});
  add(store, makePlace("b"), makeGrid(2), 1);
  expect_in_file({"a", "b"});
  rename(store, 1, "z");
  expect_in_file({"z", "b"});
  commit(store, {PlaceRemoved{1}});
  expect_in_file({"b"});
  commit(store, {MapCleared{}});
  expect_in_file({});
}

TEST_F(PlaceStoreTest, AChangeThatFailsHalfWayLeavesNothing) {
  fill();
  runSql(path_, "CREATE TRIGGER full BEFORE INSERT ON link BEGIN SELECT RAISE(ABORT, 'full'); END");
  PlaceStore store = open();
  EXPECT_THROW(add(store, makePlace("d"), makeGrid(4), 1), StoreError);
  EXPECT_EQ(store.map().size(), 3U);
  EXPECT_THROW(store.grid(4), StoreError);
  EXPECT_NO_THROW(add(store, makePlace("d"), makeGrid(4), kNoPlace));
}

TEST_F(PlaceStoreTest, RefusesALabelTwice) {
  fill();
  PlaceStore store = open();
  EXPECT_THROW(add(store, makePlace("a"), makeGrid(4), kNoPlace), StoreError);
  EXPECT_THROW(rename(store, 1, "b"), StoreError);
  EXPECT_EQ(store.map().size(), 3U);
}

TEST_F(PlaceStoreTest, TakesACellSizeThatWentThroughText) {
  fill();
  EXPECT_NO_THROW(PlaceStore(path_, 0.142875));
}

}  // namespace
}  // namespace place_memory::core
