#include "node/map/fused_map_message.h"

#include <gtest/gtest.h>

#include <vector>

#include "node/base/conversions.h"

namespace place_memory::node {
namespace {

const std_msgs::Header kHeader = makeHeader("map", ros::Time(12, 0));

core::FusedCells someCells() {
  core::FusedCells cells;
  cells.resolution = 0.25;
  cells.left = -3.0;
  cells.bottom = 7.5;
  cells.columns = 3;
  cells.rows = 2;
  cells.evidence = {127, 9, 10, 0, -22, -23};  // 0.65 is 9.9 steps above even odds, 0.196 22.6 below
  return cells;
}

TEST(FusedMapMessage, CellsAreOccupiedEmptyOrUnknown) {
  const nav_msgs::OccupancyGrid message =
      toMessage(someCells(), config::MapOptions{}, 0.5, kHeader);
  EXPECT_EQ(message.data, (std::vector<std::int8_t>{100, -1, 100, -1, -1, 0}));
}

TEST(FusedMapMessage, ThePriorAndTheBoundsCount) {
  config::MapOptions options;
  options.occupied = 0.9;
  options.empty = 0.5;
  const nav_msgs::OccupancyGrid message = toMessage(someCells(), options, 0.4, kHeader);
  EXPECT_EQ(message.data, (std::vector<std::int8_t>{100, -1, -1, -1, 0, 0}));
}

TEST(FusedMapMessage, LiesAsTheCellsDo) {
  const nav_msgs::OccupancyGrid message =
      toMessage(someCells(), config::MapOptions{}, 0.5, kHeader);
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(12, 0));
  EXPECT_EQ(message.info.map_load_time, ros::Time(12, 0));
  EXPECT_EQ(message.info.resolution, 0.25F);
  EXPECT_EQ(message.info.width, 3U);
  EXPECT_EQ(message.info.height, 2U);
  EXPECT_EQ(message.info.origin.position.x, -3.0);
  EXPECT_EQ(message.info.origin.position.y, 7.5);
  EXPECT_EQ(message.info.origin.orientation.w, 1.0);
}

TEST(FusedMapMessage, AMapWithoutAPlaceIsOneUnknownCell) {
  core::FusedCells cells;
  cells.resolution = 0.05;
  const nav_msgs::OccupancyGrid message =
      toMessage(cells, config::MapOptions{}, 0.5, kHeader);
  EXPECT_EQ(message.info.width, 1U);
  EXPECT_EQ(message.info.height, 1U);
  EXPECT_EQ(message.info.resolution, 0.05F);
  EXPECT_EQ(message.data, std::vector<std::int8_t>{-1});
}

}  // namespace
}  // namespace place_memory::node
