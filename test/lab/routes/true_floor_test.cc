#include "routes/true_floor.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace place_memory::routes {
namespace {

constexpr double kRadius = 0.22;
constexpr double kReach = 4.572;

/// Two rooms of 3 m by 4 m, between which a wall without thickness leaves a metre at the top.
class TrueFloorTest : public testing::TestWithParam<double> {
 protected:
  TrueFloorTest() : floor_(sim::Scene(world(GetParam())), kWest, kRadius, kReach) {}

  static sim::World world(double wall) {
    sim::World world;
    world.walls.push_back({{{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}, {0.0, 0.0}}, {}});
    world.walls.push_back({{{wall, 0.0}, {wall, 3.0}}, {}});
    return world;
  }

  static constexpr core::Pose2d kWest{1.0, 1.0, 0.0};
  static constexpr core::Pose2d kEast{5.0, 1.0, 0.0};
  const TrueFloor floor_;
};

TEST_P(TrueFloorTest, AWallStopsSightHoweverThinItIs) {
  const std::vector<double> seen = floor_.seenShares({kWest, kEast});
  EXPECT_GT(seen.front(), 0.45);
  EXPECT_LT(seen.front(), 0.6);
  EXPECT_GT(seen.back(), 0.95);
}

TEST_P(TrueFloorTest, ATourLooksIntoBothRooms) {
  sim::World open = world(GetParam());
  open.walls.pop_back();
  const TrueFloor::Tour of_one = TrueFloor(sim::Scene(open), kWest, kRadius, kReach).tour(1.0);
  const TrueFloor::Tour of_two = floor_.tour(1.0);
  EXPECT_EQ(of_one.viewpoints, 1U);
  EXPECT_GE(of_two.viewpoints, 2U);
  EXPECT_GT(of_two.length, of_one.length);
}

// The middle of a cell, and the border between two.
INSTANTIATE_TEST_SUITE_P(Walls, TrueFloorTest, testing::Values(2.95, 3.0, 3.03));

}  // namespace
}  // namespace place_memory::routes
