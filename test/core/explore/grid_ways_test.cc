#include "core/explore/grid_ways.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/explore/floor_plan.h"

namespace place_memory::core {
namespace {

// Two rooms of 2 m with a door of 1 m between them, and a gap of 0.1 m to a third one.
const SurveyedCells kRooms = floorPlan(
    {
        "###############",
        "#....#....#...#",
        "#....#........#",
        "#.............#",
        "#....#....#...#",
        "#....#....#...#",
        "###############",
    },
    5);

class GridWaysTest : public testing::Test {
 protected:
  static double lengthOf(Pose2d from, const std::vector<Pose2d>& way) {
    double sum = 0.0;
    for (const Pose2d& spot : way) {
      sum += std::hypot(spot.x - from.x, spot.y - from.y);
      from = spot;
    }
    return sum;
  }

  const FreeSpaceOptions options_{};
  const Pose2d robot_{1.25, 2.75, 0.0};
};

TEST_F(GridWaysTest, LeadThroughDoorsWithRoomToEachSide) {
  const FreeSpace space(options_, kRooms, robot_, {});
  const GridWays ways(space, robot_, options_.wide_berth);
  const auto goal = ways.reachedNear(6.5, 2.75, 0.2);
  ASSERT_TRUE(goal);
  const std::vector<Pose2d> way = ways.wayTo(*goal);
  ASSERT_FALSE(way.empty());
  EXPECT_NEAR(std::hypot(way.back().x - 6.5, way.back().y - 2.75), 0.0, 0.1);
  // Never shorter than the crow flies, and by no large detour.
  EXPECT_GE(lengthOf(robot_, way), 5.2);
  EXPECT_LE(lengthOf(robot_, way), 8.0);
  Pose2d from = robot_;
  for (const Pose2d& spot : way) {
    for (double part = 0.0; part <= 1.0; part += 0.02) {
      const auto cell =
          space.cellAt(from.x + part * (spot.x - from.x), from.y + part * (spot.y - from.y));
      ASSERT_TRUE(cell);
      EXPECT_GE(space.clearance(*cell), options_.radius - 0.05);
    }
    from = spot;
  }
}

TEST_F(GridWaysTest, LeadRoundWhatIsBarred) {
  const Pose2d goal{3.75, 2.75, 0.0};
  const FreeSpace open(options_, kRooms, robot_, {});
  EXPECT_TRUE(GridWays(open, robot_, 0.6).reachedNear(goal.x, goal.y, 0.1));
  const FreeSpace barred(options_, kRooms, robot_, {{2.75, 2.0, 0.4}});
  EXPECT_FALSE(GridWays(barred, robot_, 0.6).reachedNear(goal.x, goal.y, 0.1));
}

TEST_F(GridWaysTest, LeadWhereTheRobotWasHoweverNarrowThatLooks) {
  SurveyedCells survey = floorPlan({"#######", "#..#..#", "#..#..#", "#######"}, 5);
  const Pose2d robot{1.0, 1.0, 0.0};
  const FreeSpace walled(options_, survey, robot, {});
  EXPECT_FALSE(GridWays(walled, robot, 0.6).reachedNear(2.5, 1.0, 0.2));
  for (double x = 1.0; x < 2.6; x += 0.1) survey.trail.push_back({x, 1.0, 0.0});
  const FreeSpace driven(options_, survey, robot, {});
  EXPECT_TRUE(GridWays(driven, robot, 0.6).reachedNear(2.5, 1.0, 0.2));
  const FreeSpace closed(options_, survey, robot, {{1.75, 1.0, 0.3}});
  EXPECT_FALSE(GridWays(closed, robot, 0.6).reachedNear(2.5, 1.0, 0.2));
}

TEST_F(GridWaysTest, FromBeyondTheMapLeadNowhere) {
  const FreeSpace space(options_, kRooms, {-5.0, 0.0, 0.0}, {});
  const GridWays ways(space, {-5.0, 0.0, 0.0}, options_.wide_berth);
  EXPECT_FALSE(ways.reachedNear(1.25, 2.75, 0.5));
  EXPECT_TRUE(ways.wayTo(0).empty());
}

}  // namespace
}  // namespace place_memory::core
