#include "node/answer/answer_markers.h"

#include <gtest/gtest.h>

#include "node/base/conversions.h"

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const std_msgs::Header kHeader = makeHeader("map", ros::Time(7, 8));

TEST(AnswerMarkers, DiscsAreTheFullerTheMoreProbable) {
  const MarkerArray array = toMarkers(
      {{{1.0, 2.0, 0.0}, 0.85}, {{4.0, 2.0, 0.0}, 0.1}, {{9.0, 2.0, 0.0}, 0.001}}, kHeader);
  ASSERT_EQ(array.markers.size(), 2U);
  const Marker& discs = array.markers[0];
  EXPECT_EQ(discs.header.frame_id, "map");
  EXPECT_EQ(discs.action, Marker::ADD);
  ASSERT_EQ(discs.points.size(), 2U);
  EXPECT_EQ(discs.points[1].x, 4.0);
  EXPECT_NEAR(discs.colors[0].a, 0.85, 1e-6);
  EXPECT_NEAR(discs.colors[1].a, 0.1, 1e-6);
  EXPECT_EQ(array.markers[1].text, "85 %");
  EXPECT_EQ(array.markers[1].pose.position.x, 1.0);
  EXPECT_LT(array.markers[1].pose.position.y, 2.0);
}

TEST(AnswerMarkers, AnAnswerWithoutAPlaceTakesThemAway) {
  const MarkerArray array = toMarkers(std::vector<LikelyPlace>{}, kHeader);
  ASSERT_EQ(array.markers.size(), 2U);
  for (const Marker& marker : array.markers) EXPECT_EQ(marker.action, Marker::DELETE);
}

}  // namespace
}  // namespace place_memory::node
