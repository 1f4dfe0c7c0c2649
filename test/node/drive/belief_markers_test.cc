#include "node/drive/belief_markers.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;

TEST(BeliefMarkers, AProbablePlaceHasALargerDisc) {
  PlaceBelief belief;
  belief.header.frame_id = "map";
  belief.ids = {4, 2, 9};
  belief.probabilities = {0.64, 0.16, 0.001};
  belief.off_map = 0.199;
  belief.p_lost = 0.25;
  std::vector<geometry_msgs::Pose2D> locations(3);
  locations[1].x = 2.0;
  const auto markers = toMarkers(belief, locations).markers;
  ASSERT_EQ(markers.size(), 4U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);  // discs of before go
  EXPECT_NEAR(markers[1].scale.x, 2.0 * markers[2].scale.x, 1e-9);
  EXPECT_EQ(markers[2].pose.position.x, 2.0);
  EXPECT_EQ(markers[3].text, "lost 25 %, off the map 20 %");
  for (const Marker& marker : markers) EXPECT_EQ(marker.header.frame_id, "map");
}

TEST(BeliefMarkers, WithoutAPlaceNothingIsDrawn) {
  const auto markers = toMarkers(PlaceBelief(), {}).markers;
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
}

}  // namespace
}  // namespace place_memory::node
