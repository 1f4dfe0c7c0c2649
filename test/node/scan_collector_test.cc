#include "place_memory/node/scan_collector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_memory::node {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kStart = 100.0;  // [s]
constexpr double kStep = core::kPi / 90.0;
constexpr int kSensors = 4;

geometry_msgs::TransformStamped transform(const std::string& parent, const std::string& child,
                                          const core::Pose2d& pose, double stamp) {
  geometry_msgs::TransformStamped t;
  t.header.frame_id = parent;
  t.header.stamp = ros::Time(stamp);
  t.child_frame_id = child;
  t.transform.translation.x = pose.x;
  t.transform.translation.y = pose.y;
  t.transform.rotation.z = std::sin(pose.yaw / 2);
  t.transform.rotation.w = std::cos(pose.yaw / 2);
  return t;
}

core::Pose2d mounting(int sensor) {
  const double bearing = sensor * core::kPi / 2;
  return core::Pose2d{0, 0, bearing} * core::Pose2d{0.2, 0, 0};
}

std::string frame(int sensor) { return "sonar_" + std::to_string(sensor); }

// A robot with four sonars that turns on the spot; odometry, compass and tf are as it publishes
// them.
class ScanCollectorTest : public testing::Test {
 protected:
  ScanCollectorTest() {
    parameters_.scan.min_readings = 4;
    for (int k = 0; k < kSensors; ++k) {
      buffer_.setTransform(transform("base_link", frame(k), mounting(k), kStart), "test", true);
    }
  }

  ScanCollector& collector() {
    if (!collector_) collector_.emplace(parameters_, buffer_);
    return *collector_;
  }

  void begin(int headings = 11) { collector().begin(ros::Time(kStart), headings, kStep); }

  void odometry(double stamp, const core::Pose2d& pose) {
    buffer_.setTransform(transform("odom", "base_link", pose, stamp), "test");
  }

  void heading(double stamp, double yaw) {
    sensor_msgs::Imu m;
    m.header.stamp = ros::Time(stamp);
    m.orientation.z = std::sin(yaw / 2);
    m.orientation.w = std::cos(yaw / 2);
    collector().addHeading(m, ros::Time(stamp));
  }

  void range(double stamp, int sensor, double value) {
    sensor_msgs::Range m;
    m.header.stamp = ros::Time(stamp);
    m.header.frame_id = frame(sensor);
    m.field_of_view = 0.4F;
    m.min_range = 0.1F;
    m.max_range = 4.0F;
    m.range = static_cast<float>(value);
    collector().addRange(m, ros::Time(stamp));
  }

  void process(double now) { collector().process(ros::Time(now)); }

  ScanOutcome outcomeAfter(double seconds) {
    process(kStart + seconds);
    return collector().outcome(ros::Time(kStart + seconds));
  }

  // The robot turns at 0.2 rad/s from a yaw while its sensors fire in turn; the compass reads
  // `compass_error` more than odometry.
  void turnAndSense(double yaw, double compass_error, double seconds = 2.0) {
    const auto yawAt = [&](double t) { return yaw + 0.2 * t; };
    for (int i = 0; i * 0.1 < seconds + 0.2; ++i) {
      const double t = i * 0.1;
      odometry(kStart + t, {3.0, -1.0, yawAt(t)});
      heading(kStart + t, yawAt(t) + compass_error);
    }
    for (int i = 0; i * 0.05 < seconds; ++i) {
      range(kStart + 0.02 + i * 0.05, i % kSensors, i % 5 == 0 ? kInf : 1.0 + 0.1 * (i % 7));
    }
  }

  config::Parameters parameters_;
  tf2::BufferCore buffer_{ros::Duration(1000.0)};
  std::optional<ScanCollector> collector_;
};

std::uint32_t count(const ScanCollector& collector, Reject reject) {
  return collector.rejected().at(static_cast<std::size_t>(reject));
}

TEST_F(ScanCollectorTest, PlacesAReadingByTfAndCompass) {
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
  EXPECT_NEAR(scan.map_from_scan.x, 3.0, 1e-9);
  EXPECT_NEAR(scan.map_from_scan.y, -1.0, 1e-9);
  EXPECT_NEAR(scan.map_from_scan.yaw, -1.2, 1e-9);
  EXPECT_NEAR(scan.robot_in_scan.yaw, 1.7, 1e-9);
}

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
  EXPECT_EQ(by_heading.scan->map_from_scan.x, 0.0);
}

TEST_F(ScanCollectorTest, EachReadingIsPlacedAtItsOwnStamp) {
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
  EXPECT_EQ(collector().coverage().headings(), 12) << "0.4 rad in steps of 2 degrees";
  EXPECT_TRUE(collector().coverage().done());
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
  const SensorHealth& health = collector().health().sensors().at("sonar_0");
  EXPECT_EQ(health.rejected.at(static_cast<std::size_t>(Reject::kNan)), 2U);
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
  EXPECT_NE(collector().takeProblem().find("sonar_77"), std::string::npos);
  EXPECT_EQ(collector().takeProblem(), "");
}

TEST_F(ScanCollectorTest, WithoutReadingsItAsksForTheTopic) {
  begin();
  const ScanOutcome outcome = outcomeAfter(1.0);
  EXPECT_EQ(outcome.status, ScanStatus::kTooFewReadings);
  EXPECT_NE(outcome.message.find("sonar"), std::string::npos);
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
  EXPECT_NEAR(outcome.scan->map_from_scan.yaw, -0.7, 1e-9);
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
  collector().addHeading(m, ros::Time(kStart));
  EXPECT_EQ(collector().headings().size(), 0U);
  EXPECT_NE(collector().takeProblem(), "");
}

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
  sensor_msgs::Range m;
  m.header.stamp = ros::Time(kStart + 1e6);
  m.header.frame_id = "sonar_1";
  m.field_of_view = 0.4F;
  m.max_range = 4.0F;
  m.range = 1.0F;
  collector().addRange(m, ros::Time(kStart));
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

TEST_F(ScanCollectorTest, TheRobotIsWhereNewestOdometryHasItWhenTheScanEnds) {
  begin();
  turnAndSense(0.0, 0.0);
  odometry(kStart + 3.0, {3.0, -1.0, 0.1});  // it has turned back
  process(kStart + 3.02);
  const ScanOutcome outcome = collector().outcome(ros::Time(kStart + 3.02));
  ASSERT_TRUE(outcome.scan) << outcome.message;
  EXPECT_NEAR(outcome.scan->robot_in_scan.yaw, 0.1, 1e-6);
}

TEST_F(ScanCollectorTest, ASnapshotGrowsIntoTheScan) {
  begin();
  EXPECT_FALSE(collector().snapshot(ros::Time(kStart)));
  turnAndSense(0.0, 0.0);
  const ScanOutcome outcome = outcomeAfter(2.1);
  const auto snapshot = collector().snapshot(ros::Time(kStart + 2.1));
  ASSERT_TRUE(snapshot);
  ASSERT_TRUE(outcome.scan);
  EXPECT_TRUE(snapshot->grid == outcome.scan->grid);
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
