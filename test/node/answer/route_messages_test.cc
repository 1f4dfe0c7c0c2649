#include "node/answer/route_messages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::node {
namespace {

core::Place makePlace(core::PlaceId id, const std::string& label, const core::Pose2d& pose) {
  core::Place place;
  place.id = id;
  place.label = label;
  place.map_from_place = pose;
  place.place_from_robot = {0.5, 0.0, 1.0};
  return place;
}

double yawOf(const geometry_msgs::PoseStamped& pose) {
  return 2.0 * std::atan2(pose.pose.orientation.z, pose.pose.orientation.w);
}

TEST(RouteMessages, APathGoesWhereTheRobotStoodAndFacesTheNextPlace) {
  const std::vector<core::Place> places{makePlace(1, "a", {0.0, 0.0, 0.0}),
                                        makePlace(2, "b", {2.0, 0.0, 0.0}),
                                        makePlace(5, "c", {2.0, 3.0, 0.0})};
  const nav_msgs::Path path = toPath(places, "map");
  EXPECT_EQ(path.header.frame_id, "map");
  ASSERT_EQ(path.poses.size(), 3U);
  EXPECT_NEAR(path.poses[0].pose.position.x, 0.5, 1e-12);
  EXPECT_NEAR(path.poses[2].pose.position.y, 3.0, 1e-12);
  EXPECT_NEAR(yawOf(path.poses[0]), 0.0, 1e-12);
  EXPECT_NEAR(yawOf(path.poses[1]), 0.5 * core::kPi, 1e-12);
  EXPECT_NEAR(yawOf(path.poses[2]), 0.5 * core::kPi, 1e-12);
  for (const auto& pose : path.poses) EXPECT_EQ(pose.header.frame_id, "map");
}

TEST(RouteMessages, ARobotThatIsThereFacesWhereItStood) {
  const nav_msgs::Path path = toPath({makePlace(1, "a", {0.0, 0.0, 0.25})}, "map");
  ASSERT_EQ(path.poses.size(), 1U);
  EXPECT_NEAR(yawOf(path.poses[0]), 1.25, 1e-12);
  EXPECT_TRUE(toPath({}, "map").poses.empty());
}

TEST(RouteMessages, ARouteHasPlacesPathAndWhatItCosts) {
  core::Route route;
  route.cost = 42.0;
  route.time = 33.0;
  route.time_sigma = 2.0;
  route.odds = 0.78;
  const std::vector<core::Place> places{makePlace(1, "a", {0.0, 0.0, 0.0}),
                                        makePlace(2, "b", {2.0, 0.0, 0.0})};
  const Route message = toMessage(route, places, "map");
  EXPECT_EQ(message.ids, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(message.labels, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(message.path.poses.size(), 2U);
  EXPECT_EQ(message.cost, 42.0);
  EXPECT_EQ(message.time, 33.0);
  EXPECT_EQ(message.time_sigma, 2.0);
  EXPECT_EQ(message.odds, 0.78);
  EXPECT_EQ(inWords(route, places),
            "\"a\" to \"b\", 1 link, about 42 s (33 s where all is open), odds 0.78");
  EXPECT_EQ(inWords(route, {places[0]}), "the robot is at \"a\" already");
}

}  // namespace
}  // namespace place_memory::node
