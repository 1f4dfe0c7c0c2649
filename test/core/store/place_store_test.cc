#include "core/store/place_store.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

std::vector<SonarReading> makeReadings() {
  std::vector<SonarReading> readings;
  for (int i = 0; i < 30; ++i) {
    SonarReading reading;
    reading.sensor_pose = {0.1 * i, -0.7 * i, 0.05 * i};
    reading.spec = i % 3 == 0 ? SonarSpec{0.4, 0.2, 4.0} : SonarSpec{0.3, 0.0, 6.0};
    reading.range = i % 5 == 0 ? std::numeric_limits<double>::infinity() : 0.3 + 0.1 * i;
    readings.push_back(reading);
  }
  readings.back().range = 4.0;
  return readings;
}

void expectNear(const Pose2d& pose, const Pose2d& expected) {
  EXPECT_NEAR(pose.x, expected.x, 2e-6);
  EXPECT_NEAR(pose.y, expected.y, 2e-6);
  EXPECT_NEAR(pose.yaw, expected.yaw, 1e-6);
}

TEST_F(PlaceStoreTest, GivesBackWhatWasAdded) {
  const PlaceAdded a = addition(1, makePlace("a"), makeGrid(1));
  const PlaceAdded b = addition(7, makePlace("b"), makeGrid(2));
  const PlaceLink link = makeLink(1, 7);
  const auto expect_all = [&](const PlaceStore& store) {
    const PlaceMap map = store.map();
    EXPECT_EQ(map.places(), (std::vector<Place>{a.place, b.place}));
    EXPECT_EQ(map.links(), std::vector<PlaceLink>{link});
    EXPECT_EQ(map.version(), 12U);
    EXPECT_EQ(map.stamp().count(), 34);
    EXPECT_EQ(store.grid(1), makeGrid(1));
    EXPECT_EQ(store.grid(7), makeGrid(2));
    EXPECT_THROW(store.grid(2), StoreError);
    EXPECT_EQ(store.nextId(), 8);
    EXPECT_EQ(store.nextSession(), 3);
    EXPECT_TRUE(store.setAside().empty());
    EXPECT_EQ(store.whyReadOnly(), "");
  };
  PlaceIdentity identity{};
  {
    PlaceStore store = open();
    EXPECT_EQ(store.nextId(), 1);
    EXPECT_EQ(store.nextSession(), kFirstSession);
    store.commit({12, std::chrono::nanoseconds(34), {a, b, LinkAdded{link}}});
    expect_all(store);
    identity = store.identity();
  }
  EXPECT_NE(identity, PlaceIdentity{});
  EXPECT_NE(identity, PlaceStore("", kDefaultCellSize).identity());
  expect_all(open());
  EXPECT_EQ(open().identity(), identity);
}

TEST_F(PlaceStoreTest, GivesBackTheReadingsAPlaceWasLearnedFrom) {
  const std::vector<SonarReading> readings = makeReadings();
  PlaceAdded with = addition(1, makePlace("a"), makeGrid(1));
  with.readings = std::make_shared<std::vector<SonarReading>>(readings);
  {
    PlaceStore store = open();
    commit(store, {with, addition(2, makePlace("b"), makeGrid(2))});
  }
  const PlaceStore store = open();
  const std::vector<SonarReading> found = store.readings(1);
  ASSERT_EQ(found.size(), readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    expectNear(found[i].sensor_pose, readings[i].sensor_pose);
    EXPECT_EQ(found[i].spec, readings[i].spec);
    if (std::isinf(readings[i].range)) {
      EXPECT_EQ(found[i].range, readings[i].range);
    } else {
      EXPECT_NEAR(found[i].range, readings[i].range, 1e-6);
    }
  }
  EXPECT_TRUE(store.readings(2).empty());
  EXPECT_THROW(store.readings(3), StoreError);
}

TEST_F(PlaceStoreTest, KeepsEveryKindOfChange) {
  fill();
  PlaceLink replaced = makeLink(1, 2);
  replaced.first_from_second = {9.0, 8.0, 0.5};
  const LinkDirection learned{10, 20, std::chrono::nanoseconds(30)};
  {
    PlaceStore store = open();
    commit(store, {PlaceMoved{1, {4.0, 5.0, -3.0}, 6}, PlaceRenamed{2, "kitchen"},
                   LinkAdded{replaced}, LinkLearned{2, 1, learned}, LinkRemoved{3, 2},
                   LinkAdded{makeLink(1, 3)}, LinkLearned{1, 3, learned}});
  }
  const PlaceStore store = open();
  const PlaceMap map = store.map();
  EXPECT_EQ(map.find(1)->map_from_place, (Pose2d{4.0, 5.0, -3.0}));
  EXPECT_EQ(map.find(1)->session, 6);
  EXPECT_EQ(map.find(1)->place_from_robot, makePlace("a").place_from_robot);
  EXPECT_EQ(map.find("kitchen")->id, 2);
  replaced.backward = learned;
  PlaceLink other = makeLink(1, 3);
  other.forward = learned;
  EXPECT_EQ(map.links(), (std::vector<PlaceLink>{replaced, other}));
  EXPECT_EQ(store.nextSession(), 7);
  EXPECT_TRUE(store.setAside().empty());
}

TEST_F(PlaceStoreTest, APlaceGoesWithItsLinksWhicheverEndItIs) {
  fill();
  PlaceStore store = open();
  commit(store, {LinkAdded{makeLink(1, 3)}, PlaceRemoved{3}});
  EXPECT_EQ(store.map().links().size(), 1U);
  commit(store, {addition(3, makePlace("c"), makeGrid(4)), LinkAdded{makeLink(2, 3)}});
  commit(store,
         {PlaceRemoved{3}, addition(3, makePlace("c"), makeGrid(5)), LinkAdded{makeLink(1, 3)}});
  EXPECT_EQ(store.map().links(), (std::vector<PlaceLink>{makeLink(1, 2), makeLink(1, 3)}));
  EXPECT_EQ(store.grid(3), makeGrid(5));
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

TEST_F(PlaceStoreTest, RefusesWhatDoesNotFit) {
  fill();
  PlaceStore store = open();
  PlaceAdded no_grid = addition(4, makePlace("d"), makeGrid(4));
  no_grid.grid = nullptr;
  PlaceAdded no_pose = addition(4, makePlace("d"), makeGrid(4));
  no_pose.place.map_from_place.x = std::numeric_limits<double>::infinity();
  const std::vector<MapEdit> edits{
      no_grid,
      no_pose,
      addition(2, makePlace("d"), makeGrid(4)),
      addition(0, makePlace("d"), makeGrid(4)),
      addition(4, makePlace(""), makeGrid(4)),
      PlaceMoved{99, {}, 1},
      PlaceMoved{1, {std::nan(""), 0.0, 0.0}, 1},
      PlaceRenamed{99, "z"},
      GridAdapted{99, std::make_shared<EvidenceGrid>()},
      PlaceRemoved{99},
      LinkAdded{makeLink(1, 99)},
      LinkAdded{makeLink(2, 1)},
      LinkRemoved{1, 3},
      LinkLearned{1, 3, {}},
  };
  for (std::size_t i = 0; i < edits.size(); ++i) {
    EXPECT_THROW(commit(store, {edits[i]}), StoreError) << i;
  }
  EXPECT_EQ(store.map().size(), 3U);
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
