#include <gtest/gtest.h>

#include <vector>

#include "core/memory/driven_places.h"
#include "core/memory/driven_places_fixture.h"

namespace place_memory::core {
namespace {

using DrivenLinksTest = DrivenPlacesTest;

TEST_F(DrivenLinksTest, ANewPlaceIsLinkedToTheOneThatTheRobotCameFrom) {
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
  EXPECT_EQ(link->forward.through, 1.0);
  EXPECT_NEAR(link->forward.time, 1e-9, 1e-15);  // from the stamp of one to that of the other
}

TEST_F(DrivenLinksTest, LinksKeepTheHistoryOfADrive) {
  keepTwo();
  const std::vector<Traversal> history = PlaceMemory(options()).traversals();
  ASSERT_EQ(history.size(), 1U);
  EXPECT_EQ(history[0], (Traversal{1, 2, std::chrono::nanoseconds(1001),
                                   std::chrono::nanoseconds(1002), true, "driving"}));
}

TEST_F(DrivenLinksTest, OnAMapThatStaysLinksLearnAndNothingElseChanges) {
  keepTwo();
  PlaceMemory memory(options());
  KeptMap map = memory.drivenMap();
  ScanNode visit = makeNode(kNoPlace, {1.0, 2.0, 0.5});
  visit.stamp = std::chrono::nanoseconds(2000);
  visit.before = 2;
  map.nodes.push_back(visit);
  map.nodes.push_back(makeNode(3, {9.0, 2.0, 0.0}));
  map.nodes.back().before = 3;
  map.nodes[2].pose.x += 0.5;
  Tie tie;
  tie.information.setIdentity();
  tie.place = 0;
  tie.node = 3;
  map.ties.push_back(tie);
  const MapSnapshot before = memory.map();
  memory.keepTravels(map);
  const MapSnapshot after = memory.map();
  ASSERT_EQ(after.places.size(), 2U);
  EXPECT_EQ(after.places[1].map_from_place, before.places[1].map_from_place);
  ASSERT_EQ(after.links.size(), 1U);
  EXPECT_EQ(after.links[0].backward.succeeded, 1U);
  EXPECT_EQ(after.links[0].forward, before.links[0].forward);
  // Each counts once.
  memory.keepTravels(map);
  EXPECT_EQ(memory.version(), after.version);
}

TEST_F(DrivenLinksTest, KnownPlacesAreLinkedOnceTheRobotGoesFromOneToTheOther) {
  keepTwo();
  PlaceMemory memory(options());
  KeptMap map = memory.drivenMap();
  // From place 2 to a scan that was matched to place 1, half a metre before it, and back.
  ScanNode visit = makeNode(kNoPlace, {1.0, 1.5, 0.0});
  visit.stamp = std::chrono::nanoseconds(2000);
  visit.before = 2;
  visit.motion = {2.0, 0.0, 0.0};
  map.nodes.push_back(visit);
  ScanNode back = makeNode(kNoPlace, {3.0, 2.0, 0.0});
  back.stamp = std::chrono::nanoseconds(3000);
  back.before = 3;
  map.nodes.push_back(back);
  Tie tie;
  tie.information.setIdentity();
  tie.place = 0;
  tie.node = 3;
  tie.relative = {-0.5, 0.0, 0.0};
  map.ties.push_back(tie);
  tie.place = 2;
  tie.node = 4;
  tie.relative = {};
  map.ties.push_back(tie);
  memory.keep(map);
  ASSERT_EQ(memory.map().links.size(), 1U);
  EXPECT_EQ(memory.map().links[0].forward.succeeded, 2U);
  EXPECT_EQ(memory.map().links[0].backward.succeeded, 1U);
  EXPECT_EQ(memory.map().links[0].backward.last.count(), 2000);
  // Each counts once.
  const std::uint64_t version = memory.version();
  memory.keep(map);
  EXPECT_EQ(memory.version(), version);
}

TEST_F(DrivenLinksTest, ALoopThatClosesLinksItsEnds) {
  KeptMap map;
  for (int i = 0; i < 3; ++i) {
    map.nodes.push_back(makeNode(i + 1, {2.0 * i, 0.0, 0.0}));
    if (i > 0) map.nodes.back().before = i - 1;
    map.nodes.back().motion = {2.0, 0.0, 0.0};
  }
  ScanNode visit = makeNode(kNoPlace, {0.0, 0.0, 0.0});
  visit.stamp = std::chrono::nanoseconds(2000);
  visit.before = 2;
  visit.motion = {-3.5, 0.0, 0.0};
  map.nodes.push_back(visit);
  PlaceMemory memory(options());
  memory.keep(map);
  EXPECT_EQ(memory.map().links.size(), 2U);
  Tie tie;
  tie.information.setIdentity();
  tie.place = 0;
  tie.node = 3;
  tie.relative = {0.5, 0.0, 0.0};
  map.ties.push_back(tie);
  memory.keep(map);
  const MapSnapshot kept = memory.map();
  ASSERT_EQ(kept.links.size(), 3U);
  EXPECT_EQ(kept.links[1].first, 1);
  EXPECT_EQ(kept.links[1].second, 3);
  EXPECT_NEAR(kept.links[1].first_from_second.x, 4.0, 1e-9);
  EXPECT_EQ(kept.links[1].backward.succeeded, 1U);
}

}  // namespace
}  // namespace place_memory::core
