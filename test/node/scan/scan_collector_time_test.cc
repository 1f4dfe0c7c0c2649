#include <gtest/gtest.h>

#include "node/scan/scan_collector_fixture.h"

namespace place_memory::node {
namespace {

TEST_F(ScanCollectorTest, AJumpOfOdometryEndsTheScan) {
  begin();
  heading(kStart, 0.0);
  odometry(kStart, {0.0, 0.0, 0.0});
  odometry(kStart + 0.5, {0.0, 0.0, 0.0});
  odometry(kStart + 0.51, {5.0, 0.0, 0.0});
  odometry(kStart + 1.0, {5.0, 0.0, 0.0});
  for (int i = 0; i < 10; ++i) range(kStart + 0.09 * i, i % kSensors, 1.0);
  process(kStart + 1.0);
  ASSERT_TRUE(collector().failure());
  EXPECT_EQ(collector().outcome(ros::Time(kStart + 1)).status, ScanStatus::kOdometryJump);
}

TEST_F(ScanCollectorTest, ATurnOfOdometryInAnInstantEndsTheScan) {
  begin();
  odometry(kStart, {0.0, 0.0, 0.0});
  odometry(kStart + 0.5, {0.0, 0.0, 0.0});
  odometry(kStart + 0.51, {0.0, 0.0, 2.0});
  odometry(kStart + 1.0, {0.0, 0.0, 2.0});
  for (int i = 0; i < 10; ++i) range(kStart + 0.09 * i, i % kSensors, 1.0);
  process(kStart + 1.0);
  EXPECT_EQ(collector().outcome(ros::Time(kStart + 1)).status, ScanStatus::kOdometryJump);
}

TEST_F(ScanCollectorTest, TimeThatRunsBackwardsInReadingsEndsTheScan) {
  begin();
  range(kStart + 10.0, 0, 1.0);
  range(kStart + 5.0, 0, 1.0);
  EXPECT_EQ(collector().outcome(ros::Time(kStart + 5)).status, ScanStatus::kTimeJump);
  EXPECT_TRUE(collector().takeTimeJump());
  EXPECT_FALSE(collector().takeTimeJump());
}

TEST_F(ScanCollectorTest, TimeThatRunsBackwardsInHeadingsEndsTheScan) {
  begin();
  heading(kStart + 10.0, 0.0);
  heading(kStart + 5.0, 0.0);
  EXPECT_EQ(collector().outcome(ros::Time(kStart + 5)).status, ScanStatus::kTimeJump);
}

TEST_F(ScanCollectorTest, AfterTimeRanBackwardsTheNextScanIsSound) {
  begin();
  range(kStart + 1000.0, 0, 1.0);
  range(kStart + 0.0, 0, 1.0);
  ASSERT_TRUE(collector().failure());
  begin();
  turnAndSense(0.0, 0.0);
  EXPECT_TRUE(outcomeAfter(2.1).scan);
}

TEST_F(ScanCollectorTest, ReadingsThatOvertakeEachOtherAreTaken) {
  odometry(kStart, {});
  odometry(kStart + 1, {});
  begin();
  range(kStart + 0.5, 0, 1.0);
  range(kStart + 0.3, 1, 1.0);
  process(kStart + 0.6);
  EXPECT_FALSE(collector().failure());
  EXPECT_EQ(collector().readings(), 2U);
}

TEST_F(ScanCollectorTest, OneStampFarAheadDoesNotLookLikeTimeRunningBackwards) {
  odometry(kStart, {});
  odometry(kStart + 1, {});
  begin();
  rangeReceived(kStart + 1e6, frame(1), 1.0, kStart);
  range(kStart + 0.3, 0, 1.0);
  process(kStart + 0.9);
  EXPECT_FALSE(collector().failure());
  EXPECT_EQ(collector().readings(), 1U);
  EXPECT_EQ(count(collector(), Reject::kNoOdometry), 1U);
}

TEST_F(ScanCollectorTest, ABadMessageWithoutAStampDoesNotLookLikeTimeRunningBackwards) {
  begin();
  range(kStart + 10.0, 0, 1.0);
  sensor_msgs::Range bad;
  bad.header.frame_id = frame(0);
  collector().addRange(bad, ros::Time(kStart + 10.0));
  EXPECT_FALSE(collector().failure());
}

TEST_F(ScanCollectorTest, ASensorWhoseClockIsBehindDoesNotLookLikeTimeRunningBackwards) {
  begin();
  range(kStart + 10.0, 0, 1.0);
  range(kStart + 5.0, 1, 1.0);
  range(kStart + 10.1, 0, 1.0);
  range(kStart + 5.1, 1, 1.0);
  EXPECT_FALSE(collector().failure());
}

TEST_F(ScanCollectorTest, SensorsWithoutAFrameDoNotLookLikeTimeRunningBackwards) {
  begin();
  for (const double stamp : {kStart + 2.0, kStart, kStart + 2.1}) {
    rangeReceived(stamp, "", 1.0, kStart + 2.1);
  }
  EXPECT_FALSE(collector().failure());
  EXPECT_FALSE(collector().takeTimeJump());
  EXPECT_EQ(count(collector(), Reject::kBadSensor), 3U);
}

TEST_F(ScanCollectorTest, ReadingsOfAClockThatIsFarBehindAreCountedAndNamed) {
  begin();
  rangeReceived(kStart - 50.0, frame(1), 1.0, kStart + 0.5);
  EXPECT_EQ(count(collector(), Reject::kOld), 1U);
  const ScanOutcome outcome = outcomeAfter(1.0);
  EXPECT_EQ(outcome.status, ScanStatus::kTooFewReadings);
  EXPECT_NE(outcome.message.find("sonar_1 are stamped 50.5 s before"), std::string::npos)
      << outcome.message;
  EXPECT_EQ(outcome.message.find("published"), std::string::npos) << outcome.message;
}

TEST_F(ScanCollectorTest, ReadingsFromJustBeforeTheScanAreNotCounted) {
  begin();
  rangeReceived(kStart - 0.1, frame(1), 1.0, kStart + 0.1);
  EXPECT_EQ(collector().rejected(), RejectCounts{});
}

TEST_F(ScanCollectorTest, ACompassWhoseClockIsFarBehindIsNamed) {
  odometry(kStart, {});
  odometry(kStart + 1.0, {});
  begin();
  sensor_msgs::Imu m;
  m.header.stamp = ros::Time(kStart - 50.0);
  m.orientation.w = 1.0;
  collector().addHeading(m, ros::Time(kStart + 0.5));
  for (int i = 0; i < 8; ++i) range(kStart + 0.1 * i, i % kSensors, 1.0);
  const ScanOutcome outcome = outcomeAfter(0.9);
  EXPECT_EQ(outcome.status, ScanStatus::kNoHeading);
  EXPECT_NE(outcome.message.find("headings are stamped 50.5 s before"), std::string::npos)
      << outcome.message;
}

TEST_F(ScanCollectorTest, AScanWaitsForTheSensorsHeardShortlyBefore) {
  buffer_.setTransform(transform("odom", "base_link", {}, kStart), "test", true);
  for (int k = 0; k < kSensors; ++k) range(kStart - 1.0, k, 1.0);
  begin(1);
  for (int i = 1; i <= 8; ++i) range(kStart + 0.05 * i, i % 2, 1.0);
  process(kStart + 0.5);
  EXPECT_EQ(collector().readings(), 8U);
  EXPECT_FALSE(collector().coverage().done());
  range(kStart + 0.6, 2, 1.0);
  range(kStart + 0.6, 3, std::nan(""));
  process(kStart + 0.7);
  EXPECT_TRUE(collector().coverage().done());
}

TEST_F(ScanCollectorTest, AStampAtTheEndOfTimeEndsNothing) {
  buffer_.setTransform(transform("odom", "base_link", {}, kStart), "test", true);
  begin();
  range(kStart + 0.1, 0, 1.0);
  sensor_msgs::Range m;
  m.header.stamp = ros::Time(4294967295U, 0);
  m.header.frame_id = frame(1);
  m.field_of_view = 0.4F;
  m.max_range = 4.0F;
  m.range = 1.0F;
  collector().addRange(m, ros::Time(kStart + 0.2));
  process(kStart + 1.0);
  EXPECT_FALSE(collector().failure());
}

}  // namespace
}  // namespace place_memory::node
