#include "node/input/message_intake.h"

#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <limits>
#include <stdexcept>

#include "node/input/raw_message.h"

namespace place_memory::node {
namespace {

constexpr std::chrono::nanoseconds kNow = std::chrono::seconds(12);

sensor_msgs::Range rangeOf(const std::string& frame, float range, float max_range = 4.0F) {
  sensor_msgs::Range m;
  m.header.stamp = ros::Time(10.0);
  m.header.frame_id = frame;
  m.field_of_view = 0.4F;
  m.min_range = 0.1F;
  m.max_range = max_range;
  m.range = range;
  return m;
}

/// As it comes over the wire.
template <class Content>
RawMessage raw(const Content& content, const std::string& type, std::size_t cut = 0) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(content));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, content);
  RawMessage message;
  message.describe(type, ros::message_traits::md5sum(content));
  message.fill(bytes.data(), static_cast<std::uint32_t>(bytes.size() - cut));
  return message;
}

class MessageIntakeTest : public testing::Test {
 protected:
  MessageIntakeTest() { parameters_.sonar_topics = {"left", "right"}; }

  Taken take(const std::string& topic, const InputMessage& message) {
    if (!intake_) {
      intake_.emplace(
          parameters_, [](const std::string& name) { return "/" + name; }, registry_);
    }
    return intake_->take(topic, message, kNow, buffer_);
  }

  template <class Content>
  Taken say(const std::string& topic, const Content& content) {
    return take(topic, inputMessage(content));
  }

  static void expectProblem(const Taken& taken, const std::vector<std::string>& words) {
    ASSERT_EQ(taken.problems.size(), 1U) << words.front();
    for (const std::string& word : words) {
      EXPECT_NE(taken.problems[0].sentence.find(word), std::string::npos)
          << taken.problems[0].sentence;
    }
  }

  config::Parameters parameters_;
  SensorRegistry registry_;
  tf2::BufferCore buffer_;
  std::optional<MessageIntake> intake_;
};

TEST_F(MessageIntakeTest, EachTopicTakesWhatItCarries) {
  EXPECT_EQ(say("/left", rangeOf("a", 1.0F)).readings.size(), 1U);
  sensor_msgs::PointCloud cloud;
  cloud.header.stamp = ros::Time(10.0);
  cloud.points.resize(8);
  EXPECT_EQ(say("/right", cloud).readings.size(), 8U);
  sensor_msgs::LaserScan scan;
  scan.header = rangeOf("laser", 1.0F).header;
  scan.angle_max = 1.0F;
  scan.angle_increment = 0.01F;
  scan.range_max = 5.0F;
  scan.ranges.assign(101, 1.0F);
  EXPECT_EQ(say("/left", scan).readings.size(), 72U);
  EXPECT_EQ(say("/heading", std_msgs::Float64()).headings.size(), 1U);
}

TEST_F(MessageIntakeTest, AWrongTypeIsNamedWithTopicAndWhatIsNeeded) {
  const auto text = readMessage(raw(std_msgs::String(), "std_msgs/String"));
  expectProblem(take("/left", text), {"/left", "std_msgs/String", "sensor_msgs/Range"});
  EXPECT_EQ(intake_->wrongTypes().size(), 1U);
  expectProblem(say("/heading", rangeOf("a", 1.0F)),
                {"/heading", "sensor_msgs/Range", "sensor_msgs/Imu"});
  expectProblem(say("/left", sensor_msgs::Imu()), {"/left", "sensor_msgs/Imu"});
  say("/left", rangeOf("a", 1.0F));
  EXPECT_EQ(intake_->wrongTypes().size(), 1U) << "a topic that is mended is no longer named";
}

TEST_F(MessageIntakeTest, MessagesAreReadOffTheWire) {
  const Taken taken = take("/left", readMessage(raw(rangeOf("a", 1.0F), "sensor_msgs/Range")));
  ASSERT_EQ(taken.readings.size(), 1U);
  EXPECT_EQ(taken.readings[0].measurement.range, 1.0);
  expectProblem(take("/left", readMessage(raw(rangeOf("a", 1.0F), "sensor_msgs/Range", 3))),
                {"/left", "cannot be read"});
  expectProblem(take("/left", readMessage(raw(std_msgs::String(), "sensor_msgs/Range"))),
                {"another definition"});
}

TEST_F(MessageIntakeTest, ADriversWordForNoEchoIsSaidOnce) {
  expectProblem(say("/left", rangeOf("/a", 4.0F)), {"a says 4 m", "sonar/top_is_no_echo"});
  const Taken again = say("/left", rangeOf("b", 4.0F));
  EXPECT_TRUE(again.problems.empty());
  EXPECT_EQ(again.readings[0].measurement.range, std::numeric_limits<double>::infinity());
}

TEST_F(MessageIntakeTest, MinusOneIsAWordForNoEcho) {
  expectProblem(say("/left", rangeOf("a", -1.0F)), {"a says -1 m", "sonar/zero_is_no_echo"});
  const Taken again = say("/left", rangeOf("a", -1.0F));
  EXPECT_TRUE(again.problems.empty());
  EXPECT_FALSE(again.readings[0].reject);
  EXPECT_EQ(again.readings[0].measurement.range, std::numeric_limits<double>::infinity());
}

TEST_F(MessageIntakeTest, AValueOutsideTheLimitsThatIsSaidAgainAndAgainIsNamed) {
  const auto repeated = [&](const std::string& frame, float value) {
    Taken taken;
    for (int times = 0; times < 10; ++times) {
      EXPECT_TRUE(taken.problems.empty()) << times;
      sensor_msgs::Range message = rangeOf(frame, value);
      message.header.stamp += ros::Duration(0.1 * times);
      taken = say("/left", message);
    }
    EXPECT_TRUE(taken.readings[0].reject);
    return taken;
  };
  expectProblem(repeated("far", 65.535F), {"far says 65.535 m", "scan/over_range_is_no_echo"});
  expectProblem(repeated("mm", 8190.0F), {"mm says 8190 m", "scan/over_range_is_no_echo"});
  expectProblem(repeated("zero", 0.0F), {"zero says 0 m", "scan/zero_range_is_no_echo"});
  expectProblem(repeated("near", 0.05F), {"near says 0.05 m", "covered"});
  parameters_.no_echo.zero = false;
  expectProblem(repeated("minus", -1.0F), {"minus says -1 m", "sonar/zero_is_no_echo"});
}

TEST_F(MessageIntakeTest, FramesThatSensorsShareAreNamedOnce) {
  EXPECT_TRUE(say("/left", rangeOf("a", 1.0F)).problems.empty());
  expectProblem(say("/right", rangeOf("a", 1.0F)), {"/left and /right", "frame a"});
  EXPECT_TRUE(say("/right", rangeOf("a", 1.0F)).problems.empty());
  expectProblem(say("/left", rangeOf("/base_link", 1.0F)), {"/left", "frame of the robot itself"});
}

TEST_F(MessageIntakeTest, ARingWithOneFrameOnOneTopicIsNamedOnce) {
  std::vector<std::string> sentences;
  for (int sweep = 0; sweep < 3; ++sweep) {
    for (int sensor = 0; sensor < 16; ++sensor) {
      sensor_msgs::Range message = rangeOf("sonar", 1.0F + 0.1F * static_cast<float>(sensor));
      message.header.stamp += ros::Duration(0.1 * sweep);
      for (const auto& problem : say("/left", message).problems) {
        sentences.push_back(problem.sentence);
      }
    }
  }
  ASSERT_EQ(sentences.size(), 1U);
  for (const char* const word : {"/left", "one frame sonar", "a frame of its own"}) {
    EXPECT_NE(sentences[0].find(word), std::string::npos) << sentences[0];
  }
}

TEST_F(MessageIntakeTest, OneSensorWithoutStampsIsNotTakenForSeveral) {
  for (int times = 0; times < 20; ++times) {
    sensor_msgs::Range message = rangeOf("sonar", 1.0F + 0.1F * static_cast<float>(times));
    message.header.stamp = ros::Time();
    EXPECT_TRUE(say("/left", message).problems.empty()) << times;
  }
}

TEST_F(MessageIntakeTest, AMessageThatComesTwiceIsNoSecondSensor) {
  for (int times = 0; times < 40; ++times) {
    sensor_msgs::Range message = rangeOf("sonar", 1.0F + 0.1F * static_cast<float>(times / 2));
    message.header.stamp += ros::Duration(0.1 * (times / 2));
    EXPECT_TRUE(say("/left", message).problems.empty()) << times;
  }
}

TEST_F(MessageIntakeTest, OneTopicForTwoThingsIsRefused) {
  parameters_.heading_topic = "left";
  try {
    say("/left", rangeOf("a", 1.0F));
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    for (const char* const word : {"sonar_topics", "heading_topic", "/left"}) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

TEST_F(MessageIntakeTest, UnitsThatAreNotMetresAreNamed) {
  expectProblem(say("/left", rangeOf("cm", 120.0F, 400.0F)), {"cm", "max_range of 400", "metres"});
  const auto sayOf = [&](const std::string& frame, float range) {
    sensor_msgs::Range message = rangeOf(frame, range, 90.0F);
    message.header.stamp += ros::Duration(static_cast<double>(range));
    return say("/right", message);
  };
  Taken taken;
  for (float range = 50.0F; range < 70.0F; range += 1.0F) taken = sayOf("far", range);
  expectProblem(taken, {"every range of far", "beyond the grid"});
  sayOf("near", 2.0F);
  for (float range = 50.0F; range < 80.0F; range += 1.0F) {
    EXPECT_TRUE(sayOf("near", range).problems.empty()) << range;
  }
}

TEST_F(MessageIntakeTest, ASensorsBadLimitsAreNamedEachTime) {
  sensor_msgs::Range m = rangeOf("a", 1.0F);
  m.field_of_view = 56.0F;
  for (int i = 0; i < 2; ++i) {
    expectProblem(say("/left", m), {"a", "field_of_view", "degrees"});
  }
}

TEST_F(MessageIntakeTest, OdometryOnATopicIsATransform) {
  parameters_.odom_topic = "odom_topic";
  nav_msgs::Odometry m;
  m.header.stamp = ros::Time(10.0);
  m.header.frame_id = "/odom";
  m.child_frame_id = "base_link";
  m.pose.pose.position.x = 3.0;
  m.pose.pose.orientation.w = 1.0;
  const Taken taken = say("/odom_topic", m);
  ASSERT_EQ(taken.transforms.size(), 1U);
  EXPECT_EQ(taken.transforms[0].header.frame_id, "odom");
  EXPECT_EQ(taken.transforms[0].child_frame_id, "base_link");
  EXPECT_EQ(taken.transforms[0].transform.translation.x, 3.0);
  EXPECT_TRUE(taken.problems.empty());
  m.child_frame_id = "base_footprint";
  expectProblem(say("/odom_topic", m), {"base_footprint", "base_link"});
}

}  // namespace
}  // namespace place_memory::node
