#include "node/base/cell_marker.h"

#include <gtest/gtest.h>

#include "node/base/conversions.h"

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;

const std_msgs::Header kHeader = makeHeader("odom", ros::Time(7, 8));

TEST(CellMarker, IsACubeForEachOccupiedCell) {
  core::EvidenceGrid grid(core::GridGeometry{0.1});
  grid.add(32, 42, 90);
  grid.add(0, 0, 12);
  grid.add(5, 5, 11);
  grid.add(6, 6, -90);
  const Marker marker = toCellMarker(grid, {1.0, 2.0, core::kPi}, kHeader, kScanColor, 0.02);
  EXPECT_EQ(marker.header.frame_id, "odom");
  EXPECT_EQ(marker.action, Marker::ADD);
  EXPECT_EQ(marker.type, Marker::CUBE_LIST);
  ASSERT_EQ(marker.points.size(), 2U);
  EXPECT_NEAR(marker.points[1].x, 1.05, 1e-9);
  EXPECT_NEAR(marker.points[1].y, 0.05, 1e-9);
  EXPECT_NEAR(marker.pose.position.x, 1.0, 1e-9);
  EXPECT_NEAR(marker.pose.position.z, 0.02, 1e-9);
  EXPECT_NEAR(marker.pose.orientation.z, 1.0, 1e-9);
  EXPECT_EQ(marker.color.r, kScanColor.red);
  EXPECT_GT(marker.color.a, 0.5F);
}

TEST(CellMarker, OfAnEmptyGridTakesTheLastOneAway) {
  const Marker marker = toCellMarker(core::EvidenceGrid(), {}, kHeader, kScanColor, 0.0);
  EXPECT_EQ(marker.action, Marker::DELETE);
}

}  // namespace
}  // namespace place_memory::node
