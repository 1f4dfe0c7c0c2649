#include <gtest/gtest.h>

#include "node/scan/scan_collector_fixture.h"

namespace place_memory::node {
namespace {

TEST_F(ScanCollectorTest, HeadingAloneGivesTheSameScanAsOdometry) {
  begin();
  turnAndSense(2.9, 0.4);
  const ScanOutcome by_odometry = outcomeAfter(2.1);
  ASSERT_TRUE(by_odometry.scan) << by_odometry.message;

  collector_.reset();
  parameters_.odom_frame = "";
  begin();
  turnAndSense(2.9, 0.4);
  const ScanOutcome by_heading = outcomeAfter(2.1);
  ASSERT_TRUE(by_heading.scan) << by_heading.message;

  ASSERT_EQ(by_heading.scan->readings.size(), by_odometry.scan->readings.size());
  for (std::size_t i = 0; i < by_heading.scan->readings.size(); ++i) {
    const core::Pose2d& a = by_heading.scan->readings[i].sensor_pose;
    const core::Pose2d& b = by_odometry.scan->readings[i].sensor_pose;
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
    EXPECT_NEAR(core::wrapAngle(a.yaw - b.yaw), 0.0, 1e-6);
  }
  EXPECT_TRUE(by_heading.scan->grid == by_odometry.scan->grid);
  EXPECT_EQ(by_heading.scan->odom_from_scan.x, 0.0);
}

TEST_F(ScanCollectorTest, NeedsAHeadingBesideOdometry) {
  odometry(kStart, {});
  odometry(kStart + 1, {});
  begin();
  for (int k = 0; k < kSensors; ++k) range(kStart + 0.1 * k, k, 1.0);
  EXPECT_EQ(outcomeAfter(0.9).status, ScanStatus::kNoHeading);
}

TEST_F(ScanCollectorTest, ASlowCompassServesAShortScan) {
  odometry(kStart - 1, {0, 0, 0.3});
  odometry(kStart + 1, {0, 0, 0.3});
  heading(kStart - 0.4, 1.0);
  begin();
  for (int k = 0; k < kSensors; ++k) range(kStart + 0.1 * k, k, 1.0);
  const ScanOutcome outcome = outcomeAfter(0.5);
  ASSERT_TRUE(outcome.scan) << outcome.message;
  EXPECT_NEAR(outcome.scan->odom_from_scan.yaw, -0.7, 1e-9);
}

TEST_F(ScanCollectorTest, AnOldHeadingIsNoHeading) {
  parameters_.odom_frame = "";
  heading(kStart - 5.0, 1.0);
  begin();
  for (int k = 0; k < kSensors; ++k) range(kStart + 0.1 * k, k, 1.0);
  EXPECT_EQ(outcomeAfter(1.0).status, ScanStatus::kNoHeading);
}

TEST_F(ScanCollectorTest, AHeadingFromTheFutureIsLeftOut) {
  sensor_msgs::Imu m;
  m.header.stamp = ros::Time(kStart + 1000);
  m.orientation.w = 1.0;
  addHeading(m, kStart);
  EXPECT_EQ(collector().headings().size(), 0U);
  EXPECT_NE(collector().problems().inWords(), "");
}

TEST_F(ScanCollectorTest, TheOffsetOfTheCompassIsThatOfTheScanAlone) {
  begin();
  turnAndSense(0.0, 1.0);
  const ScanOutcome first = outcomeAfter(2.1);
  ASSERT_TRUE(first.scan) << first.message;
  EXPECT_NEAR(first.scan->odom_from_scan.yaw, -1.0, 1e-6);

  // The robot went on to where the compass errs by another angle.
  collector().begin(toNanoseconds(kStart + 10.0), 1, kStep);
  for (const double t : {10.0, 10.5}) {
    odometry(kStart + t, {3.0, -1.0, 0.2});
    heading(kStart + t, 0.2 + 0.4);
  }
  for (int k = 0; k < kSensors; ++k) range(kStart + 10.1 + 0.1 * k, k, 1.0);
  process(kStart + 10.6);
  const ScanOutcome second = collector().outcome(toNanoseconds(kStart + 10.6));
  ASSERT_TRUE(second.scan) << second.message;
  EXPECT_NEAR(second.scan->odom_from_scan.yaw, -0.4, 1e-6);
}

TEST_F(ScanCollectorTest, WithoutOdometryAReadingWaitsForTheNextHeading) {
  parameters_.odom_frame = "";
  parameters_.scan.min_readings = 1;
  begin(1);
  heading(kStart, 0.0);
  range(kStart + 0.2, 0, 1.0);
  process(kStart + 0.3);
  EXPECT_EQ(collector().readings(), 0U) << "the robot turns until the next heading";
  EXPECT_TRUE(collector().waiting());
  heading(kStart + 0.4, 0.4);
  const ScanOutcome outcome = outcomeAfter(0.45);
  ASSERT_TRUE(outcome.scan) << outcome.message;
  EXPECT_NEAR(outcome.scan->readings.front().sensor_pose.yaw, 0.2, 1e-6);
}

TEST_F(ScanCollectorTest, WithoutOdometryTheLastHeadingServesWhereNoOtherComes) {
  parameters_.odom_frame = "";
  parameters_.scan.min_readings = 1;
  begin(1);
  heading(kStart, 0.1);
  range(kStart + 0.2, 0, 1.0);
  process(kStart + 0.2 + parameters_.scan.tf_timeout - 0.01);
  EXPECT_TRUE(collector().waiting());
  process(kStart + 0.2 + parameters_.scan.tf_timeout);
  EXPECT_FALSE(collector().waiting());
  EXPECT_EQ(collector().readings(), 1U);
}

TEST_F(ScanCollectorTest, AHeadingBeforeSimulatedTimeRunsIsLeftOutWithoutAWord) {
  sensor_msgs::Imu m;
  m.header.stamp = ros::Time(kStart);
  m.orientation.w = 1.0;
  addHeading(m, 0.0);
  EXPECT_EQ(collector().headings().size(), 0U);
  EXPECT_TRUE(collector().problems().empty());
}

}  // namespace
}  // namespace place_memory::node
