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
  EXPECT_EQ(collector().outcome(toNanoseconds(kStart + 1)).status, ScanStatus::kOdometryJump);
}

TEST_F(ScanCollectorTest, ATurnOfOdometryInAnInstantEndsTheScan) {
  begin();
  odometry(kStart, {0.0, 0.0, 0.0});
  odometry(kStart + 0.5, {0.0, 0.0, 0.0});
  odometry(kStart + 0.51, {0.0, 0.0, 2.0});
  odometry(kStart + 1.0, {0.0, 0.0, 2.0});
  for (int i = 0; i < 10; ++i) range(kStart + 0.09 * i, i % kSensors, 1.0);
  process(kStart + 1.0);
  EXPECT_EQ(collector().outcome(toNanoseconds(kStart + 1)).status, ScanStatus::kOdometryJump);
}

TEST_F(ScanCollectorTest, AStaleStampOfASensorIsLeftOutAndTheScanGoesOn) {
  for (const double behind : {2.0, 5.0, kStart - 3.0}) {
    collector_.reset();
    begin();
    turnAndSense(0.0, 0.0);
    const std::size_t used = 40;
    rangeReceived(kStart + 2.0 - behind, frame(1), 1.0, kStart + 2.05);
    const ScanOutcome outcome = outcomeAfter(2.1);
    ASSERT_TRUE(outcome.scan) << outcome.message;
    EXPECT_EQ(outcome.scan->readings.size(), used) << behind;
    EXPECT_EQ(count(collector(), Reject::kOld), 1U) << behind;
    EXPECT_NE(outcome.problem.find("sonar_1"), std::string::npos) << outcome.problem;
    EXPECT_EQ(health("sonar_1").rejected.at(static_cast<std::size_t>(Reject::kOld)), 1U);
  }
}

TEST_F(ScanCollectorTest, AStaleStampIsCountedWithoutAScanToo) {
  range(kStart, 0, 1.0);
  rangeReceived(kStart - 50.0, frame(0), 1.0, kStart + 0.1);
  EXPECT_EQ(health("sonar_0").rejected.at(static_cast<std::size_t>(Reject::kOld)), 1U);
  EXPECT_NE(collector().problems().inWords().find("sonar_0"), std::string::npos);
}

TEST_F(ScanCollectorTest, EveryInputThatIsWrongIsNamed) {
  begin();
  turnAndSense(0.0, 0.0);
  for (int k = 0; k < 2; ++k) rangeReceived(kStart - 5.0, frame(k), 1.0, kStart + 2.0);
  sensor_msgs::Imu stale;
  stale.header.stamp = ros::Time(7.0);
  stale.orientation.w = 1.0;
  addHeading(stale, kStart + 2.0);
  const std::string problem = outcomeAfter(2.1).problem;
  for (const char* word : {"sonar_0", "sonar_1", "heading"}) {
    EXPECT_NE(problem.find(word), std::string::npos) << problem;
  }
}

TEST_F(ScanCollectorTest, AStaleHeadingIsLeftOutAndTheScanGoesOn) {
  begin();
  turnAndSense(0.0, 0.3);
  sensor_msgs::Imu stale;
  stale.header.stamp = ros::Time(7.0);
  stale.orientation.w = 1.0;
  addHeading(stale, kStart + 2.0);
  const ScanOutcome outcome = outcomeAfter(2.1);
  ASSERT_TRUE(outcome.scan) << outcome.message;
  EXPECT_NEAR(outcome.scan->odom_from_scan.yaw, -0.3, 1e-6);
  EXPECT_NE(outcome.problem.find("heading left out"), std::string::npos) << outcome.problem;
  const CompassHealth compass = collector().compassHealth();
  EXPECT_EQ(compass.left_out, 1U);
  EXPECT_GT(compass.messages, 1U);
}

TEST_F(ScanCollectorTest, AfterTimeWasSetBackTheNextScanIsSound) {
  begin();
  range(kStart + 1000.0, 0, 1.0);
  heading(kStart + 1000.0, 0.0);
  collector().forgetTime();
  begin();
  turnAndSense(0.0, 0.0);
  const ScanOutcome outcome = outcomeAfter(2.1);
  ASSERT_TRUE(outcome.scan) << outcome.message;
  EXPECT_EQ(collector().rejected(), RejectCounts{});
}

TEST_F(ScanCollectorTest, StampsThatFollowAStepOfTheClockAreNotStale) {
  begin();
  range(kStart + 5.0, 0, 1.0);
  heading(kStart + 5.0, 0.0);
  collector().stepBack(std::chrono::seconds(5));
  turnAndSense(0.0, 0.0);
  EXPECT_TRUE(outcomeAfter(2.1).scan);
  EXPECT_EQ(count(collector(), Reject::kOld), 0U);
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

TEST_F(ScanCollectorTest, OneStampFarAheadDoesNotMakeTheOthersStale) {
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

TEST_F(ScanCollectorTest, ABadMessageWithoutAStampIsNotStale) {
  begin();
  range(kStart + 10.0, 0, 1.0);
  sensor_msgs::Range bad;
  bad.header.frame_id = frame(0);
  addRange(bad, kStart + 10.0);
  EXPECT_FALSE(collector().failure());
  EXPECT_EQ(count(collector(), Reject::kOld), 0U);
}

TEST_F(ScanCollectorTest, ASensorWhoseClockIsBehindThatOfOthersIsNotStale) {
  begin();
  range(kStart + 10.0, 0, 1.0);
  range(kStart + 5.0, 1, 1.0);
  range(kStart + 10.1, 0, 1.0);
  range(kStart + 5.1, 1, 1.0);
  EXPECT_FALSE(collector().failure());
  EXPECT_EQ(count(collector(), Reject::kOld), 0U);
}

TEST_F(ScanCollectorTest, SensorsWithoutAFrameAreNotStale) {
  begin();
  for (const double stamp : {kStart + 2.0, kStart, kStart + 2.1}) {
    rangeReceived(stamp, "", 1.0, kStart + 2.1);
  }
  EXPECT_FALSE(collector().failure());
  EXPECT_EQ(count(collector(), Reject::kOld), 0U);
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
  addHeading(m, kStart + 0.5);
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
  EXPECT_FALSE(collector().sweep().coverage().done());
  range(kStart + 0.6, 2, 1.0);
  range(kStart + 0.6, 3, std::nan(""));
  process(kStart + 0.7);
  EXPECT_TRUE(collector().sweep().coverage().done());
}

TEST_F(ScanCollectorTest, AStepOfTheClockToTheEndOfTimeAndBackThrowsNothing) {
  const std::chrono::nanoseconds end = std::chrono::seconds(4294967295);
  begin();
  turnAndSense(0.0, 0.0);
  RangeAdapter adapter("/sonar", parameters_, registry_);
  sensor_msgs::Range m;
  m.header.stamp = ros::Time(kStart);
  m.header.frame_id = frame(0);
  m.field_of_view = 0.4F;
  m.max_range = 4.0F;
  m.range = 1.0F;
  collector().addReading(adapter.adapt(m), end);
  collector().process(end);
  const ScanOutcome outcome = collector().outcome(end);
  EXPECT_TRUE(outcome.scan) << outcome.message;
  begin();
  turnAndSense(0.0, 0.0);
  EXPECT_TRUE(outcomeAfter(2.1).scan);
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
  addRange(m, kStart + 0.2);
  process(kStart + 1.0);
  EXPECT_FALSE(collector().failure());
}

}  // namespace
}  // namespace place_memory::node
