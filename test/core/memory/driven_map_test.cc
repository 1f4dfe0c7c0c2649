#include "core/memory/driven_map.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/mapping/mapper.h"
#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

std::shared_ptr<const std::vector<SonarReading>> makeReadings() {
  std::vector<SonarReading> readings;
  for (int i = 0; i < 24; ++i) {
    SonarReading reading;
    reading.sensor_pose = {0.1, 0.0, i * kPi / 12.0};
    reading.spec = {0.4, 0.1, 4.0};
    reading.range = 1.0 + 0.1 * i;
    readings.push_back(reading);
  }
  return std::make_shared<const std::vector<SonarReading>>(readings);
}

ScanNode makeNode(PlaceId place, const Pose2d& pose) {
  ScanNode node;
  node.stamp = std::chrono::nanoseconds(1000 + place);
  node.session = 1;
  node.pose = pose;
  node.place = place;
  node.readings = makeReadings();
  return node;
}

class DrivenMapTest : public PlaceStoreTest {
 protected:
  DrivenMap openMap() const { return {path_, kDefaultCellSize, SonarModelOptions()}; }

  // Places 1 and 2 with a scan between them.
  void keepTwo() const {
    KeptMap map;
    map.nodes = {makeNode(1, {1.0, 2.0, 0.5}), makeNode(kNoPlace, {2.0, 2.0, 0.25}),
                 makeNode(2, {3.0, 2.0, -1.0})};
    map.nodes[1].before = 0;
    map.nodes[2].before = 1;
    map.nodes[1].motion = {1.0, 0.0, kPi / 2.0};
    map.nodes[2].motion = {1.0, 0.0, 0.0};
    openMap().keep(map);
  }
};

TEST_F(DrivenMapTest, APlaceOfTheMapperIsAPlaceOfTheStore) {
  keepTwo();
  const PlaceStore store = open();
  const PlaceMap map = store.map();
  ASSERT_EQ(map.size(), 2U);
  const Place& place = *map.find(2);
  EXPECT_EQ(place.label, "place_2");
  EXPECT_EQ(place.learned.count(), 1002);
  EXPECT_NE(place.identity, PlaceIdentity{});
  EXPECT_NEAR(place.map_from_place.x, 3.0, 1e-12);
  EXPECT_NEAR(place.map_from_place.yaw, 0.0, 1e-12);  // its axes are the map's
  EXPECT_NEAR(place.place_from_robot.yaw, -1.0, 1e-12);
  EXPECT_EQ(store.readings(2).size(), 24U);
  EXPECT_FALSE(store.grid(2) == EvidenceGrid(GridGeometry{kDefaultCellSize}));
}

TEST_F(DrivenMapTest, ANewPlaceIsLinkedToTheOneThatTheRobotCameFrom) {
  keepTwo();
  const PlaceMap map = open().map();
  const PlaceLink* link = map.findLink(1, 2);
  ASSERT_NE(link, nullptr);
  // By odometry the robot came to (1, 1), turned by 90 degrees, of where it stood at place 1.
  const Pose2d robot = map.find(1)->place_from_robot.inverse() * link->first_from_second *
                       map.find(2)->place_from_robot;
  EXPECT_NEAR(robot.x, 1.0, 1e-9);
  EXPECT_NEAR(robot.y, 1.0, 1e-9);
  EXPECT_NEAR(robot.yaw, kPi / 2.0, 1e-9);
  EXPECT_EQ(link->forward.succeeded, 1U);
  EXPECT_EQ(link->backward.succeeded, 0U);
}

TEST_F(DrivenMapTest, IsTakenUpAsItWasKept) {
  keepTwo();
  const DrivenMap map = openMap();
  ASSERT_EQ(map.kept().nodes.size(), 3U);
  EXPECT_NEAR(map.kept().nodes[2].pose.yaw, -1.0, 1e-12);
  EXPECT_EQ(map.kept().nodes[2].place, 2);
  EXPECT_EQ(map.kept().next_place, 3);
  Mapper mapper{MapperOptions()};
  mapper.restore(map.kept());
  EXPECT_EQ(mapper.places().size(), 2U);
  EXPECT_EQ(mapper.firstOfDrive(), 3U);
}

TEST_F(DrivenMapTest, APlaceThatMovesKeepsItsGridAndItsName) {
  keepTwo();
  {
    PlaceStore store = open();
    rename(store, 2, "kitchen");
  }
  const EvidenceGrid grid = open().grid(2);
  {
    DrivenMap map = openMap();
    KeptMap moved = map.kept();
    moved.nodes[2].pose = {3.5, 2.5, -0.75};
    map.keep(moved);
    EXPECT_EQ(map.labelOf(2), "kitchen");
  }
  const PlaceStore store = open();
  const Place place = *store.map().find(2);
  EXPECT_EQ(place.label, "kitchen");
  EXPECT_NEAR(place.map_from_place.x, 3.5, 1e-12);
  EXPECT_NEAR(place.map_from_place.yaw, 0.25, 1e-12);
  EXPECT_EQ(store.grid(2), grid);
}

TEST_F(DrivenMapTest, APlaceThatTheMapperGaveUpGoesAndItsIdIsNeverGivenAgain) {
  keepTwo();
  {
    DrivenMap map = openMap();
    KeptMap fewer = map.kept();
    fewer.nodes[2].place = kNoPlace;
    map.keep(fewer);
    EXPECT_EQ(map.labelOf(2), "");
    EXPECT_EQ(map.labelOf(1), "place_1");
  }
  EXPECT_EQ(openMap().kept().next_place, 3);
}

TEST_F(DrivenMapTest, APlaceThatWasLearnedWhileStandingIsANode) {
  {
    PlaceStore store = open();
    PlaceAdded edit = addition(1, makePlace("desk"), makeGrid(1));
    edit.readings = makeReadings();
    PlaceAdded without = addition(2, makePlace("old"), makeGrid(2));
    commit(store, {edit, without});
  }
  DrivenMap map = openMap();
  ASSERT_EQ(map.kept().nodes.size(), 1U);  // of the other one the readings are not known
  const ScanNode& node = map.kept().nodes[0];
  const Place place = makePlace("desk");
  const Pose2d pose = place.map_from_place * place.place_from_robot;
  EXPECT_NEAR(node.pose.x, pose.x, 1e-9);
  EXPECT_NEAR(node.pose.yaw, pose.yaw, 1e-9);
  EXPECT_EQ(node.session, 2);
  const SonarReading& reading = node.readings->front();
  const Pose2d sensor = place.place_from_robot.inverse() * makeReadings()->front().sensor_pose;
  EXPECT_NEAR(reading.sensor_pose.x, sensor.x, 1e-5);
  EXPECT_NEAR(reading.sensor_pose.yaw, sensor.yaw, 1e-5);
  map.keep(map.kept());
  EXPECT_EQ(map.labelOf(1), "desk");
  EXPECT_EQ(map.labelOf(2), "old");
}

TEST_F(DrivenMapTest, APlaceWhoseNameIsTakenGetsAnother) {
  {
    PlaceStore store = open();
    add(store, makePlace("place_2"), makeGrid(1), kNoPlace);
  }
  DrivenMap map = openMap();
  KeptMap one;
  one.nodes = {makeNode(2, {1.0, 2.0, 0.5})};
  map.keep(one);
  EXPECT_EQ(map.labelOf(2), "place_2_2");
}

}  // namespace
}  // namespace place_memory::core
