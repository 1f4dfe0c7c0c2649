#include "core/sensing/sweep_builder.h"

#include <gtest/gtest.h>

#include "core/sensing/sweep_fixture.h"

namespace place_memory::core {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

using Added = SweepBuilder::Added;

SweepBuilder sweepOf(int headings, bool odometry = true) { return {headings, kStep, {}, odometry}; }

TEST(NewScanId, IsGivenOnce) {
  const std::uint64_t first = newScanId();
  EXPECT_GT(first, 0U);
  EXPECT_GT(newScanId(), first);
}

TEST(SweepBuilder, CoversTheHeadingsOfItsReadings) {
  SweepBuilder sweep = sweepOf(3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(sweep.add(located(milliseconds(100 * i), 1, {0, 0, i * kStep})), Added::kUsed);
  }
  EXPECT_EQ(sweep.readings().size(), 3U);
  EXPECT_EQ(sweep.coverage().headings(), 3);
  sweep.skip(1);
  EXPECT_TRUE(sweep.coverage().done());
}

TEST(SweepBuilder, AJumpOfOdometryIsNoReading) {
  SweepBuilder sweep = sweepOf(3);
  sweep.add(located(seconds(10), 1, {0, 0, 0}));
  EXPECT_EQ(sweep.add(located(seconds(10), 1, {0.31, 0, 0})), Added::kJumped);
  EXPECT_EQ(sweep.add(located(seconds(10), 1, {0, 0, kPi / 9 + 0.01})), Added::kJumped);
  EXPECT_EQ(sweep.readings().size(), 1U);
  EXPECT_EQ(sweep.add(located(seconds(10), 1, {0.29, 0, 0})), Added::kUsed);
  EXPECT_EQ(sweep.add(located(seconds(11), 1, {3.5, 0, 0})), Added::kUsed)
      << "a fast robot gets so far in a second";
  EXPECT_EQ(sweep.add(located(seconds(10), 1, {0.3, 0, 0})), Added::kUsed)
      << "readings overtake each other";
}

TEST(SweepBuilder, WithoutOdometryTheCompassMayTurnAsItLikes) {
  SweepBuilder sweep = sweepOf(3, false);
  sweep.add(located(seconds(10), 1, {0, 0, 0}));
  EXPECT_EQ(sweep.add(located(seconds(10), 1, {0, 0, 2.0})), Added::kUsed);
}

TEST(SweepBuilder, KnowsTheLongestGapUpToTwoSeconds) {
  SweepBuilder sweep = sweepOf(3);
  sweep.add(located(milliseconds(1000), 1, {}));
  EXPECT_EQ(sweep.longestGap(), nanoseconds(0));
  sweep.add(located(milliseconds(1400), 1, {}));
  sweep.add(located(milliseconds(1500), 1, {}));
  EXPECT_EQ(sweep.longestGap(), milliseconds(400));
  sweep.add(located(seconds(4294967295), 1, {}));
  EXPECT_EQ(sweep.longestGap(), seconds(2));
}

TEST(SweepBuilder, HoldsABoundedNumberOfReadings) {
  SweepBuilder sweep = sweepOf(1);
  for (std::size_t i = 0; i < SweepBuilder::kMaxReadings; ++i) {
    ASSERT_EQ(sweep.add(located(seconds(1), 1, {})), Added::kUsed);
  }
  EXPECT_TRUE(sweep.full());
  EXPECT_EQ(sweep.add(located(seconds(1), 1, {})), Added::kFull);
  EXPECT_EQ(sweep.readings().size(), SweepBuilder::kMaxReadings);
}

TEST(SweepBuilder, TheScanLiesAlongCompassEastWhereTheRobotBegan) {
  SweepBuilder sweep = sweepOf(2);
  const Pose2d first{3.0, -1.0, 0.5};
  const Pose2d second{3.2, -1.0, 0.6};
  sweep.add(located(seconds(10), 1, first, 1.5));
  sweep.add(located(seconds(11), 2, second, 2.5));
  const SonarModel model{SonarModelOptions()};
  const Scan scan = sweep.scan(1.2, second, model, GridGeometry());
  EXPECT_NEAR(scan.odom_from_scan.x, 3.0, 1e-12);
  EXPECT_NEAR(scan.odom_from_scan.y, -1.0, 1e-12);
  EXPECT_NEAR(scan.odom_from_scan.yaw, -1.2, 1e-12);
  ASSERT_EQ(scan.readings.size(), 2U);
  EXPECT_NEAR(scan.readings[0].sensor_pose.x, 0.0, 1e-12);
  EXPECT_NEAR(scan.readings[0].sensor_pose.yaw, 1.7, 1e-12) << "as the compass had it";
  EXPECT_EQ(scan.readings[1].range, 2.5);
  const Pose2d robot = scan.odom_from_scan * scan.robot_in_scan;
  EXPECT_NEAR(robot.x, second.x, 1e-12);
  EXPECT_NEAR(robot.yaw, second.yaw, 1e-12);
  EXPECT_TRUE(scan.grid == model.build(scan.readings, GridGeometry()));
}

TEST(SweepBuilder, WithoutOdometryTheScanHasNoPose) {
  SweepBuilder sweep = sweepOf(1, false);
  sweep.add(located(seconds(10), 1, {0, 0, 0.7}));
  const Scan scan = sweep.scan(0.0, {0, 0, 0.7}, SonarModel{SonarModelOptions()}, GridGeometry());
  EXPECT_EQ(scan.odom_from_scan.x, 0.0);
  EXPECT_EQ(scan.odom_from_scan.yaw, 0.0);
  EXPECT_NEAR(scan.robot_in_scan.yaw, 0.7, 1e-12);
}

}  // namespace
}  // namespace place_memory::core
