#include "core/memory/driven_places.h"

#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "core/memory/driven_places_fixture.h"
#include "core/random_scan.h"

namespace place_memory::core {
namespace {

TEST_F(DrivenPlacesTest, APlaceOfTheMapperIsAPlaceOfTheStore) {
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

TEST_F(DrivenPlacesTest, IsTakenUpAsItWasKept) {
  keepTwo();
  const KeptMap map = PlaceMemory(options()).drivenMap();
  ASSERT_EQ(map.nodes.size(), 3U);
  EXPECT_NEAR(map.nodes[2].pose.yaw, -1.0, 1e-12);
  EXPECT_EQ(map.nodes[2].place, 2);
  EXPECT_EQ(map.next_place, 3);
  EXPECT_TRUE(map.named.empty());
  Mapper mapper{MapperOptions()};
  mapper.restore(map);
  EXPECT_EQ(mapper.places().size(), 2U);
  EXPECT_EQ(mapper.firstOfDrive(), 3U);
}

TEST_F(DrivenPlacesTest, APlaceThatMovesKeepsItsGridAndItsName) {
  keepTwo();
  {
    PlaceStore store = open();
    rename(store, 2, "kitchen");
  }
  const EvidenceGrid grid = open().grid(2);
  {
    PlaceMemory memory(options());
    KeptMap moved = memory.drivenMap();
    EXPECT_EQ(moved.named, std::vector<PlaceId>{2});
    moved.nodes[2].pose = {3.5, 2.5, -0.75};
    memory.keep(moved);
    EXPECT_EQ(labelOf(memory, 2), "kitchen");
  }
  const PlaceStore store = open();
  const Place place = *store.map().find(2);
  EXPECT_EQ(place.label, "kitchen");
  EXPECT_NEAR(place.map_from_place.x, 3.5, 1e-12);
  EXPECT_NEAR(place.map_from_place.yaw, 0.25, 1e-12);
  EXPECT_EQ(store.grid(2), grid);
}

TEST_F(DrivenPlacesTest, APlaceThatTheMapperGaveUpGoesAndItsIdIsNeverGivenAgain) {
  keepTwo();
  {
    PlaceMemory memory(options());
    KeptMap fewer = memory.drivenMap();
    fewer.nodes[2].place = kNoPlace;
    memory.keep(fewer);
    EXPECT_EQ(labelOf(memory, 2), "");
    EXPECT_EQ(labelOf(memory, 1), "place_1");
  }
  EXPECT_EQ(PlaceMemory(options()).drivenMap().next_place, 3);
}

TEST_F(DrivenPlacesTest, APlaceThatWasLearnedWhileStandingIsANode) {
  {
    PlaceStore store = open();
    PlaceAdded edit = addition(1, makePlace("desk"), makeGrid(1));
    edit.readings = makeReadings();
    PlaceAdded without = addition(2, makePlace("old"), makeGrid(2));
    commit(store, {edit, without});
  }
  PlaceMemory memory(options());
  const KeptMap map = memory.drivenMap();
  ASSERT_EQ(map.nodes.size(), 1U);  // of the other one the readings are not known
  const ScanNode& node = map.nodes[0];
  const Place place = makePlace("desk");
  const Pose2d pose = place.map_from_place * place.place_from_robot;
  EXPECT_NEAR(node.pose.x, pose.x, 1e-9);
  EXPECT_NEAR(node.pose.yaw, pose.yaw, 1e-9);
  EXPECT_EQ(node.session, 1);  // it is the oldest one, and so the map's
  const SonarReading& reading = node.readings->front();
  const Pose2d sensor = place.place_from_robot.inverse() * makeReadings()->front().sensor_pose;
  EXPECT_NEAR(reading.sensor_pose.x, sensor.x, 1e-5);
  EXPECT_NEAR(reading.sensor_pose.yaw, sensor.yaw, 1e-5);
  memory.keep(map);
  EXPECT_EQ(labelOf(memory, 1), "desk");
  EXPECT_EQ(labelOf(memory, 2), "old");
}

TEST_F(DrivenPlacesTest, APlaceWhoseNameIsTakenGetsAnother) {
  {
    PlaceStore store = open();
    add(store, makePlace("place_2"), makeGrid(1), kNoPlace);
  }
  PlaceMemory memory(options());
  KeptMap one;
  one.nodes = {makeNode(2, {1.0, 2.0, 0.5})};
  memory.keep(one);
  EXPECT_EQ(labelOf(memory, 2), "place_2_2");
}

TEST_F(DrivenPlacesTest, WhoListensHearsWhatTheDriveMadeAsOneChange) {
  keepTwo();
  PlaceMemory memory(options());
  std::vector<MapChange> changes;
  memory.listen([&](const MapChange& change) { changes.push_back(change); });
  KeptMap map = memory.drivenMap();
  map.nodes[0].pose.x += 0.5;
  map.nodes[2].place = kNoPlace;
  map.nodes.push_back(makeNode(3, {5.0, 2.0, 0.0}));
  memory.keep(map);
  ASSERT_EQ(changes.size(), 1U);
  ASSERT_EQ(changes[0].edits.size(), 3U);
  EXPECT_EQ(std::get<PlaceRemoved>(changes[0].edits[0]).id, 2);
  EXPECT_EQ(std::get<PlaceMoved>(changes[0].edits[1]).id, 1);
  EXPECT_EQ(std::get<PlaceAdded>(changes[0].edits[2]).place.id, 3);
  EXPECT_EQ(memory.version(), changes[0].version);
  // Nothing has changed since.
  memory.keep(map);
  EXPECT_EQ(changes.size(), 1U);
}

TEST_F(DrivenPlacesTest, NewPlacesAreKeptWithoutThoseThatMoved) {
  keepTwo();
  {
    PlaceMemory memory(options());
    KeptMap map = memory.drivenMap();
    map.nodes[0].pose.x += 0.5;
    map.nodes[2].place = kNoPlace;
    map.nodes.push_back(makeNode(3, {5.0, 2.0, 0.0}));
    map.nodes[3].before = 0;
    memory.keepNewPlaces(map);
    EXPECT_EQ(memory.size(), 3U);
    EXPECT_NEAR(memory.place(1)->map_from_place.x, 1.0, 1e-9);
    ASSERT_EQ(memory.map().links.size(), 2U);
    EXPECT_EQ(memory.map().links[1].second, 3);
    memory.keep(map);
    EXPECT_EQ(memory.size(), 2U);
    EXPECT_NEAR(memory.place(1)->map_from_place.x, 1.5, 1e-9);
    map.nodes.push_back(makeNode(4, {7.0, 2.0, 0.0}));
    memory.keepNewPlaces(map);
  }
  // What was not kept yet of the last one but its place is made up for from that.
  const KeptMap taken = PlaceMemory(options()).drivenMap();
  ASSERT_EQ(taken.nodes.size(), 5U);
  EXPECT_EQ(taken.nodes[4].place, 4);
  EXPECT_NEAR(taken.nodes[4].pose.x, 7.0, 1e-9);
}

TEST_F(DrivenPlacesTest, APlaceThatSomebodyRemovedMeanwhileStaysRemoved) {
  keepTwo();
  PlaceMemory memory(options());
  const KeptMap map = memory.drivenMap();
  memory.remove("place_2");
  memory.keep(map);
  EXPECT_EQ(labelOf(memory, 2), "");
  EXPECT_EQ(memory.size(), 1U);
}

TEST_F(DrivenPlacesTest, WhileADriveSaysWhereTheRobotIsAPlaceIsLearnedThereAndLinked) {
  keepTwo();
  PlaceMemory memory(options());
  DriveWhereabouts whereabouts;
  whereabouts.session = kFirstSession;
  whereabouts.map_from_odom = Pose2d{10.0, 0.0, 0.0};
  whereabouts.current = 2;
  memory.followDrive(whereabouts);
  EXPECT_EQ(memory.whereabouts().current_label, "place_2");
  Scan scan = makeRandomScan(1);
  scan.odom_from_scan = {1.0, 1.0, 0.0};
  const PlaceMemory::Learned learned = memory.learn(scan, "desk");
  EXPECT_FALSE(learned.apart);
  EXPECT_EQ(learned.place.session, kFirstSession);
  EXPECT_NEAR(learned.place.map_from_place.x, 11.0, 1e-9);
  const MapSnapshot map = memory.map();
  ASSERT_EQ(map.links.size(), 2U);
  EXPECT_EQ(map.links[1].first, 2);
  // Place 2 lies at (3, 2), and the new one at (11, 1).
  EXPECT_NEAR(map.links[1].first_from_second.x, 8.0, 1e-9);
  EXPECT_NEAR(map.links[1].first_from_second.y, -1.0, 1e-9);
  // How it got there is for the drive to tell.
  EXPECT_EQ(map.links[1].forward, LinkDirection{});
  EXPECT_EQ(memory.traversals().size(), 1U);
}

}  // namespace
}  // namespace place_memory::core
