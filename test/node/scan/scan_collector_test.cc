#include <gtest/gtest.h>

#include <cmath>

#include "node/scan/scan_collector_fixture.h"

namespace place_memory::node {
namespace {

TEST_F(ScanCollectorTest, LocatesAReadingByTfAndCompass) {
  begin();
  for (const double t : {0.0, 1.0}) {
    odometry(kStart + t, {3.0, -1.0, 0.5});
    heading(kStart + t, 1.7);
  }
  for (int k = 0; k < kSensors; ++k) range(kStart + 0.1 * k, k, 2.0);
  const ScanOutcome outcome = outcomeAfter(0.9);

  ASSERT_TRUE(outcome.scan) << outcome.message;
  const core::Scan& scan = *outcome.scan;
  ASSERT_EQ(scan.readings.size(), 4U);
  for (int k = 0; k < kSensors; ++k) {
    const core::Pose2d expected = core::Pose2d{0, 0, 1.7} * mounting(k);
    const core::Pose2d& got = scan.readings.at(static_cast<std::size_t>(k)).sensor_pose;
    EXPECT_NEAR(got.x, expected.x, 1e-9);
    EXPECT_NEAR(got.y, expected.y, 1e-9);
    EXPECT_NEAR(core::wrapAngle(got.yaw - expected.yaw), 0.0, 1e-9);
  }
  // Compass east is 1.2 rad clockwise of odometry's x axis.
  EXPECT_NEAR(scan.odom_from_scan.x, 3.0, 1e-9);
  EXPECT_NEAR(scan.odom_from_scan.y, -1.0, 1e-9);
  EXPECT_NEAR(scan.odom_from_scan.yaw, -1.2, 1e-9);
  EXPECT_NEAR(scan.robot_in_scan.yaw, 1.7, 1e-9);
}

TEST_F(ScanCollectorTest, EachReadingIsLocatedAtItsOwnStamp) {
  begin();
  turnAndSense(0.0, 0.0);
  const ScanOutcome outcome = outcomeAfter(2.1);
  ASSERT_TRUE(outcome.scan) << outcome.message;
  ASSERT_EQ(outcome.scan->readings.size(), 40U);
  for (int i = 0; i < 40; ++i) {
    const double yaw = 0.2 * (0.02 + i * 0.05) + mounting(i % kSensors).yaw;
    const double got = outcome.scan->readings.at(static_cast<std::size_t>(i)).sensor_pose.yaw;
    EXPECT_NEAR(core::wrapAngle(got - yaw), 0.0, 1e-6) << i;
  }
}

TEST_F(ScanCollectorTest, CountsHeadings) {
  begin();
  turnAndSense(0.0, 0.0);
  process(kStart + 2.1);
  EXPECT_EQ(collector().sweep().coverage().headings(), 12) << "0.4 rad in steps of 2 degrees";
  EXPECT_TRUE(collector().sweep().coverage().done());
}

TEST_F(ScanCollectorTest, ASlantedSonarIsSeenFromAbove) {
  geometry_msgs::TransformStamped up = transform("base_link", "sonar_0", {}, kStart);
  const double pitch = -core::kPi / 3;  // REP 103: nose up
  up.transform.rotation.z = 0.0;
  up.transform.rotation.y = std::sin(pitch / 2);
  up.transform.rotation.w = std::cos(pitch / 2);
  buffer_.setTransform(up, "test", true);
  parameters_.scan.min_readings = 1;
  begin();
  odometry(kStart, {});
  odometry(kStart + 1, {});
  heading(kStart, 0.0);
  range(kStart + 0.1, 0, 2.0);
  const ScanOutcome outcome = outcomeAfter(0.5);
  ASSERT_TRUE(outcome.scan) << outcome.message;
  const core::SonarReading& reading = outcome.scan->readings.front();
  EXPECT_NEAR(reading.range, 1.0, 1e-6);
  EXPECT_NEAR(reading.spec.max_range, 2.0, 1e-6);
}

TEST_F(ScanCollectorTest, ASonarThatLooksUpIsLeftOut) {
  geometry_msgs::TransformStamped up = transform("base_link", "sonar_0", {}, kStart);
  up.transform.rotation.z = 0.0;
  up.transform.rotation.y = -std::sqrt(0.5);
  up.transform.rotation.w = std::sqrt(0.5);
  buffer_.setTransform(up, "test", true);
  begin();
  odometry(kStart, {});
  odometry(kStart + 1, {});
  range(kStart + 0.1, 0, 2.0);
  process(kStart + 0.5);
  EXPECT_EQ(count(collector(), Reject::kVertical), 1U);
}

TEST_F(ScanCollectorTest, CountsWhatItLeavesOutByReason) {
  begin();
  turnAndSense(0.0, 0.0);
  range(kStart + 1.9, 0, std::nan(""));
  range(kStart + 1.9, 0, std::nan(""));
  range(kStart + 1.9, 1, -kInf);
  range(kStart + 1.9, 2, 9.0);
  const ScanOutcome outcome = outcomeAfter(2.1);
  EXPECT_EQ(count(collector(), Reject::kNan), 2U);
  EXPECT_EQ(count(collector(), Reject::kTooClose), 1U);
  EXPECT_EQ(count(collector(), Reject::kAboveMaxRange), 1U);
  ASSERT_TRUE(outcome.scan);
  EXPECT_NE(outcome.message.find("2 range is NaN"), std::string::npos) << outcome.message;
  EXPECT_EQ(health("sonar_0").rejected.at(static_cast<std::size_t>(Reject::kNan)), 2U);
}

TEST_F(ScanCollectorTest, ReadingsFromBeforeTheScanAreNotOfIt) {
  odometry(kStart - 1, {});
  odometry(kStart + 1, {});
  begin();
  range(kStart - 0.01, 0, 1.0);
  process(kStart + 0.5);
  EXPECT_EQ(collector().readings(), 0U);
}

TEST_F(ScanCollectorTest, ReadingsAfterItIsClosedAreNotOfIt) {
  odometry(kStart, {});
  odometry(kStart + 1, {});
  begin();
  range(kStart + 0.1, 0, 1.0);
  collector().close();
  range(kStart + 0.2, 0, 1.0);
  process(kStart + 0.5);
  EXPECT_EQ(collector().readings(), 1U);
}

TEST_F(ScanCollectorTest, AReadingWaitsForItsTransform) {
  begin();
  range(kStart + 0.1, 0, 1.0);
  process(kStart + 0.2);
  EXPECT_TRUE(collector().waiting());
  odometry(kStart, {});
  odometry(kStart + 0.2, {});
  process(kStart + 0.3);
  EXPECT_FALSE(collector().waiting());
  EXPECT_EQ(collector().readings(), 1U);
}

TEST_F(ScanCollectorTest, WithoutOdometrysTransformItSaysSoAndNamesTheFrames) {
  begin();
  for (int k = 0; k < kSensors; ++k) range(kStart + 0.1, k, 1.0);
  const ScanOutcome outcome = outcomeAfter(1.0);
  EXPECT_EQ(outcome.status, ScanStatus::kNoOdometry);
  EXPECT_EQ(count(collector(), Reject::kNoOdometry), 4U);
  EXPECT_NE(outcome.message.find("odom"), std::string::npos);
  EXPECT_NE(outcome.message.find("base_link"), std::string::npos);
}

TEST_F(ScanCollectorTest, WithoutASensorsTransformItNamesBothFrames) {
  odometry(kStart, {});
  odometry(kStart + 1, {});
  begin();
  for (int i = 0; i < 4; ++i) range(kStart + 0.1, 77, 1.0);
  const ScanOutcome outcome = outcomeAfter(0.9);
  EXPECT_EQ(outcome.status, ScanStatus::kTooFewReadings);
  EXPECT_EQ(count(collector(), Reject::kNoTransform), 4U);
  EXPECT_NE(outcome.message.find("sonar_77"), std::string::npos) << outcome.message;
  EXPECT_NE(outcome.message.find("base_link"), std::string::npos) << outcome.message;
  EXPECT_NE(collector().problems().inWords().find("sonar_77"), std::string::npos);
}

TEST_F(ScanCollectorTest, WithoutReadingsItAsksForTheTopic) {
  begin();
  const ScanOutcome outcome = outcomeAfter(1.0);
  EXPECT_EQ(outcome.status, ScanStatus::kTooFewReadings);
  EXPECT_NE(outcome.message.find("sonar"), std::string::npos);
}

TEST_F(ScanCollectorTest, TheRobotIsWhereNewestOdometryHasItWhenTheScanEnds) {
  begin();
  turnAndSense(0.0, 0.0);
  odometry(kStart + 3.0, {3.0, -1.0, 0.1});  // it has turned back
  process(kStart + 3.02);
  const ScanOutcome outcome = collector().outcome(toNanoseconds(kStart + 3.02));
  ASSERT_TRUE(outcome.scan) << outcome.message;
  EXPECT_NEAR(outcome.scan->robot_in_scan.yaw, 0.1, 1e-6);
}

TEST_F(ScanCollectorTest, ASnapshotGrowsIntoTheScan) {
  begin();
  EXPECT_FALSE(collector().snapshot(toNanoseconds(kStart)));
  turnAndSense(0.0, 0.0);
  const ScanOutcome outcome = outcomeAfter(2.1);
  const auto snapshot = collector().snapshot(toNanoseconds(kStart + 2.1));
  ASSERT_TRUE(snapshot);
  ASSERT_TRUE(outcome.scan);
  EXPECT_TRUE(snapshot->grid == outcome.scan->grid);
}

TEST_F(ScanCollectorTest, EveryScanHasANumberOfItsOwn) {
  begin();
  turnAndSense(0.0, 0.0);
  const ScanOutcome first = outcomeAfter(2.1);
  begin();
  turnAndSense(0.0, 0.0);
  const ScanOutcome second = outcomeAfter(2.1);
  ASSERT_TRUE(first.scan && second.scan);
  EXPECT_GT(first.scan->id, 0U);
  EXPECT_GT(second.scan->id, first.scan->id);
}

TEST_F(ScanCollectorTest, DroppingForgetsTheScan) {
  begin();
  turnAndSense(0.0, 0.0);
  process(kStart + 2.1);
  collector().drop();
  EXPECT_FALSE(collector().collecting());
  EXPECT_EQ(collector().readings(), 0U);
}

}  // namespace
}  // namespace place_memory::node
