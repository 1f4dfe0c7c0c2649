#include "node/map/place_handles.h"

#include <gtest/gtest.h>
#include <visualization_msgs/InteractiveMarkerControl.h>

#include <vector>

#include "node/map/nearest_places.h"

namespace place_memory::node {
namespace {

core::Place makePlace(core::PlaceId id, double x, double y) {
  core::Place place;
  place.id = id;
  place.label = "room " + std::to_string(id);
  place.map_from_place = {x, y, 0.5};
  return place;
}

TEST(PlaceHandles, LiesOnThePlaceInTheMapFrame) {
  const auto handle = toHandle(makePlace(7, 2.0, -3.0), "map", false);
  EXPECT_EQ(handle.name, "place 7");
  EXPECT_EQ(handle.description, "room 7");
  EXPECT_EQ(handle.header.frame_id, "map");
  EXPECT_EQ(handle.pose.position.x, 2.0);
  EXPECT_EQ(handle.pose.position.y, -3.0);
  ASSERT_EQ(handle.menu_entries.size(), 3U);
}

TEST(PlaceHandles, NobodyCanDragAPlace) {
  for (const auto& control : toHandle(makePlace(7, 2.0, -3.0), "map", false).controls) {
    EXPECT_EQ(control.interaction_mode, visualization_msgs::InteractiveMarkerControl::BUTTON);
  }
}

TEST(PlaceHandles, AsksWhetherTheRobotIsThereWhereScansSaySo) {
  const auto handle = toHandle(makePlace(7, 2.0, -3.0), "map", true);
  ASSERT_EQ(handle.menu_entries.size(), 5U);
  EXPECT_EQ(handle.menu_entries[3].id, static_cast<std::uint32_t>(PlaceEntry::kConfirm));
  EXPECT_EQ(handle.menu_entries[4].id, static_cast<std::uint32_t>(PlaceEntry::kCut));
  const auto other = toHandle(makePlace(7, 2.0, -3.0), "map", false);
  EXPECT_NE(handle.controls[0].markers[0].color.r, other.controls[0].markers[0].color.r);
}

TEST(NearestPlaces, AreTheNearestOnesFirst) {
  const std::vector<core::Place> places{makePlace(1, 0.0, 0.0), makePlace(2, 9.0, 0.0),
                                        makePlace(3, 5.0, 1.0), makePlace(4, 20.0, 0.0)};
  const auto near = nearestPlaces(places, {8.0, 0.0, 0.0}, 2);
  ASSERT_EQ(near.size(), 2U);
  EXPECT_EQ(near[0]->id, 2);
  EXPECT_EQ(near[1]->id, 3);
  EXPECT_EQ(nearestPlaces(places, {}, 9).size(), 4U);
  EXPECT_TRUE(nearestPlaces({}, {}, 9).empty());
}

}  // namespace
}  // namespace place_memory::node
