#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

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

}  // namespace
}  // namespace place_memory::core
