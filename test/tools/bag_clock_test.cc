#include "tools/bag_clock.h"

#include <gtest/gtest.h>

namespace place_memory::tools {
namespace {

/// Notes `count` messages at 10 Hz from 1000 s on, recorded so long after their stamps [s].
void note(ClockMeasurement& measurement, const std::string& topic, const std::string& frame,
          double lag, int count = 100) {
  for (int i = 0; i < count; ++i) {
    StoredMessage message;
    message.topic = topic;
    const ros::Time stamp(1000.0 + 0.1 * i);
    message.recorded = later(stamp, lag);
    measurement.note(message.recorded);
    measurement.note(message, {stamp, frame}, true);
  }
}

TEST(ClockMeasurement, ARecorderWithTheRobotsClockHasNoOffset) {
  ClockMeasurement measurement;
  note(measurement, "sonar", "sonar_0", 0.02);
  note(measurement, "heading", "imu", 0.05);
  note(measurement, "tf", "base_link", -0.1);
  const BagClock clock = measurement.clock();
  EXPECT_EQ(clock.offset, 0.0);
  EXPECT_TRUE(clock.strays.empty());
  EXPECT_EQ(clock.first, ros::Time(1000.0));
  EXPECT_NEAR(clock.last.toSec(), 1009.9, 1e-6);
}

TEST(ClockMeasurement, AnOffsetIsMeasuredWhateverItIs) {
  for (const double offset : {-900.0, -30.0, -0.5, 0.5, 30.0, 1e6}) {
    ClockMeasurement measurement;
    note(measurement, "sonar", "sonar_0", offset + 0.02, 5000);
    note(measurement, "heading", "imu", offset);
    note(measurement, "tf", "base_link", offset);
    const BagClock clock = measurement.clock();
    EXPECT_NEAR(clock.offset, offset, 1e-3);
    EXPECT_EQ(clock.first, ros::Time(1000.0));
    EXPECT_TRUE(clock.credible(ros::Time(1000.0), later(ros::Time(1000.5), offset)));
    EXPECT_FALSE(clock.credible(ros::Time(1002.0), later(ros::Time(1000.0), offset)));
    EXPECT_FALSE(clock.credible(ros::Time(), later(ros::Time(1000.0), offset)));
    EXPECT_NEAR(clock.received(later(ros::Time(1000.0), offset)).toSec(), 1000.0, 1e-3);
  }
}

TEST(ClockMeasurement, ASensorWithAClockOfItsOwnIsNamedAndDoesNotRule) {
  ClockMeasurement measurement;
  for (int i = 0; i < 5; ++i) note(measurement, "sonar", "sonar_" + std::to_string(i), 0.0);
  note(measurement, "sonar", "sonar_5", 7.0, 1000);
  note(measurement, "heading", "imu", 0.0);
  note(measurement, "tf", "base_link", 0.0);
  const BagClock clock = measurement.clock();
  EXPECT_EQ(clock.offset, 0.0);
  ASSERT_EQ(clock.strays.size(), 1U);
  EXPECT_EQ(clock.strays.begin()->first, InputName("sonar", "sonar_5"));
  EXPECT_NEAR(clock.strays.begin()->second, 7.0, 1e-6);
  EXPECT_EQ(clock.first, ros::Time(1000.0));
}

TEST(ClockMeasurement, ATopicOfManySensorsDoesNotOutweighTheOthers) {
  ClockMeasurement measurement;
  for (int i = 0; i < 12; ++i) note(measurement, "sonar", "sonar_" + std::to_string(i), 4.0);
  note(measurement, "heading", "imu", 0.0);
  note(measurement, "tf", "base_link", 0.0);
  EXPECT_EQ(measurement.clock().offset, 0.0);
  EXPECT_EQ(measurement.clock().strays.size(), 12U);
}

TEST(ClockMeasurement, MessagesThatAreHeldUpAndWrongStampsDoNotMoveIt) {
  ClockMeasurement measurement;
  for (const char* topic : {"sonar", "heading", "tf"}) {
    note(measurement, topic, "frame", 4.0, 20);
    note(measurement, topic, "frame", 9.0, 20);
    note(measurement, topic, "frame", 6.0, 20);
    note(measurement, topic, "frame", -1e5, 15);
  }
  const BagClock clock = measurement.clock();
  EXPECT_EQ(clock.offset, 4.0);
  EXPECT_GE(clock.lateness, 5.0);
  EXPECT_TRUE(clock.strays.empty());
}

TEST(ClockMeasurement, WithoutStampsTheRecorderIsBelieved) {
  ClockMeasurement measurement;
  measurement.note(ros::Time(5.0));
  measurement.note(ros::Time(7.0));
  const BagClock clock = measurement.clock();
  EXPECT_EQ(clock.offset, 0.0);
  EXPECT_EQ(clock.first, ros::Time(5.0));
  EXPECT_EQ(clock.last, ros::Time(7.0));
}

TEST(Later, StaysWithinWhatTimeCanHold) {
  EXPECT_EQ(later(ros::Time(5.0), -10.0), ros::TIME_MIN);
  EXPECT_EQ(later(ros::TIME_MAX, 10.0), ros::TIME_MAX);
  EXPECT_EQ(later(ros::Time(5.0), 1.5), ros::Time(6.5));
}

}  // namespace
}  // namespace place_memory::tools
