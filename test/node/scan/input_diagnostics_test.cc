#include "node/scan/input_diagnostics.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;
using Status = diagnostic_updater::DiagnosticStatusWrapper;
using std::chrono::seconds;

SensorHealth sound(const std::string& name) {
  SensorHealth sensor;
  sensor.id = 1;
  sensor.name = sensor.frame = name;
  sensor.topic = "/sonar";
  sensor.messages = 10;
  return sensor;
}

InputHealth healthOf(const std::vector<SensorHealth>& sensors) {
  InputHealth health;
  health.sensors = sensors;
  health.sonar_topics = {"/sonar"};
  health.heading_topic = "/robot/heading";
  health.compass.heard = true;
  health.compass.messages = 100;
  return health;
}

std::uint32_t& rejects(SensorHealth& sensor, Reject reject) {
  return sensor.rejected.at(static_cast<std::size_t>(reject));
}

Status diagnose(const std::vector<SensorHealth>& sensors) {
  Status status;
  diagnoseSonars(healthOf(sensors), status);
  return status;
}

void expectSays(const Status& status, int level, const std::vector<std::string>& words) {
  EXPECT_EQ(status.level, level) << status.message;
  for (const std::string& word : words) {
    EXPECT_NE(status.message.find(word), std::string::npos) << status.message;
  }
}

TEST(DiagnoseSonars, WithoutASensorItAsksForTheTopic) {
  expectSays(diagnose({}), Level::WARN, {"no sensor", "/sonar"});
}

TEST(DiagnoseSonars, ATopicOnWhichNothingEverCameIsNamed) {
  InputHealth health = healthOf({sound("front")});
  health.sonar_topics = {"/sonar", "/range/lft"};
  Status status;
  diagnoseSonars(health, status);
  expectSays(status, Level::WARN, {"nothing has come on /range/lft (sonar_topics)"});
  EXPECT_EQ(silentTopics(healthOf({sound("front")})), "");
  EXPECT_EQ(silentTopics(healthOf({})), "") << "that there is no sensor at all says more";
  health.wrong_types = {"the topic /range/lft carries std_msgs/String"};
  EXPECT_EQ(silentTopics(health), "") << "it speaks, though not of ranges";
}

TEST(DiagnoseSonars, ASensorThatDoesNotSpeakInMetresIsNamed) {
  SensorHealth centimetres = sound("front");
  centimetres.unit_problem = "front has a max_range of 457 m: are its limits in metres?";
  expectSays(diagnose({centimetres}), Level::WARN, {"front has a max_range of 457 m"});
}

TEST(DiagnoseSonars, SoundSensorsAreOk) {
  expectSays(diagnose({sound("a"), sound("b")}), Level::OK, {"2 sensors"});
}

TEST(DiagnoseSonars, ASensorWhoseLimitsMakeNoSenseIsAnErrorThatNamesIt) {
  SensorHealth bad = sound("left");
  bad.sensor_problem = "field_of_view must be in (0, pi] rad, not -1";
  expectSays(diagnose({sound("a"), bad}), Level::ERROR, {"left: field_of_view"});
}

TEST(DiagnoseSonars, ASilentSensorIsAWarning) {
  SensorHealth silent = sound("rear");
  silent.silent = seconds(10);
  expectSays(diagnose({sound("a"), silent}), Level::WARN, {"rear: silent for 10.0 s", "/sonar"});
  silent.silent = seconds(5);
  EXPECT_EQ(diagnose({silent}).level, Level::OK);
}

TEST(DiagnoseSonars, ASensorOfWhichNothingIsUsedIsAWarning) {
  SensorHealth useless = sound("a");
  rejects(useless, Reject::kNan) = 10;
  const auto status = diagnose({useless});
  expectSays(status, Level::WARN, {"a: readings are rejected", "wiring"});
  ASSERT_EQ(status.values.size(), 2U);
  EXPECT_EQ(status.values[0].key, "a readings [Hz]");
  EXPECT_EQ(status.values[0].value, "1.0");
  EXPECT_EQ(status.values[1].key, "a left out [Hz]: range is NaN");
  EXPECT_EQ(status.values[1].value, "1.0");
}

TEST(DiagnoseSonars, SomeRejectedReadingsAreNoWarning) {
  SensorHealth sensor = sound("a");
  rejects(sensor, Reject::kTooClose) = 8;
  EXPECT_EQ(diagnose({sensor}).level, Level::OK);
  rejects(sensor, Reject::kTooClose) = 9;
  EXPECT_EQ(diagnose({sensor}).level, Level::WARN);
}

TEST(DiagnoseSonars, OneStaleStampNamesItsSensor) {
  SensorHealth sensor = sound("left");
  rejects(sensor, Reject::kOld) = 1;
  expectSays(diagnose({sensor}), Level::WARN, {"left: 1 readings", "clock"});
}

TEST(DiagnoseCompass, SaysItsRate) {
  Status status;
  diagnoseCompass(healthOf({}), status);
  expectSays(status, Level::OK, {"10.0 Hz"});
}

TEST(DiagnoseCompass, NeverHeardOrSilentItAsksForTheTopic) {
  InputHealth health = healthOf({});
  health.compass = {};
  Status never;
  diagnoseCompass(health, never);
  expectSays(never, Level::WARN, {"no heading has come", "/robot/heading"});

  health.compass.heard = true;
  health.compass.silent = seconds(7);
  Status silent;
  diagnoseCompass(health, silent);
  expectSays(silent, Level::WARN, {"silent for 7.0 s", "/robot/heading"});
}

TEST(DiagnoseCompass, SaysWhyHeadingsAreLeftOut) {
  InputHealth health = healthOf({});
  health.compass.left_out = 3;
  health.compass.problem = "its quaternion is not finite";
  Status status;
  diagnoseCompass(health, status);
  expectSays(status, Level::WARN, {"3 of 100", "quaternion is not finite"});
}

class DiagnoseTransforms : public testing::Test {
 protected:
  void add(const std::string& parent, const std::string& child, double stamp, bool is_static) {
    geometry_msgs::TransformStamped t;
    t.header.frame_id = parent;
    t.child_frame_id = child;
    t.header.stamp = ros::Time(stamp);
    t.transform.rotation.w = 1.0;
    buffer_.setTransform(t, "test", is_static);
  }

  Status diagnose(const std::vector<SensorHealth>& sensors, double now) {
    Status status;
    diagnoseTransforms(buffer_, left_out_, healthOf(sensors), parameters_,
                       std::chrono::nanoseconds(std::llround(now * 1e9)), status);
    return status;
  }

  tf2::BufferCore buffer_;
  TransformInput::LeftOut left_out_;
  config::Parameters parameters_;
};

TEST_F(DiagnoseTransforms, IsOkWhereEveryFrameIsKnown) {
  add("odom", "base_link", 100.0, false);
  add("base_link", "left", 1.0, true);
  expectSays(diagnose({sound("left")}, 100.5), Level::OK, {});
}

TEST_F(DiagnoseTransforms, NamesTheFramesOfOdometry) {
  add("base_link", "left", 1.0, true);
  expectSays(diagnose({}, 100.0), Level::WARN, {"from base_link to odom", "odom_frame"});
  parameters_.odom_frame = "";
  expectSays(diagnose({}, 100.0), Level::OK, {});
}

TEST_F(DiagnoseTransforms, SaysThatOdometryIsOld) {
  add("odom", "base_link", 100.0, false);
  expectSays(diagnose({}, 103.0), Level::WARN, {"3.0 s old"});
}

TEST_F(DiagnoseTransforms, NamesTheFrameOfASensorThatIsHeard) {
  add("odom", "base_link", 100.0, false);
  SensorHealth silent = sound("gone");
  silent.silent = seconds(60);
  const Status status = diagnose({sound("ghost"), silent}, 100.0);
  expectSays(status, Level::WARN, {"from ghost to base_link", "static_transform_publisher"});
  EXPECT_EQ(status.message.find("gone"), std::string::npos) << status.message;
}

TEST_F(DiagnoseTransforms, ATransformOfASensorThatIsNoLongerPublishedIsNamed) {
  add("odom", "base_link", 100.0, false);
  add("base_link", "left", 90.0, false);
  expectSays(diagnose({sound("left")}, 100.5), Level::WARN, {"from left is 10.5 s old"});
  add("base_link", "left", 100.0, false);
  expectSays(diagnose({sound("left")}, 100.5), Level::OK, {});
}

TEST_F(DiagnoseTransforms, SensorsThatShareAFrameAreNamed) {
  add("odom", "base_link", 100.0, false);
  add("base_link", "front", 1.0, true);
  std::vector<SensorHealth> sensors{sound("front"), sound("front")};
  expectSays(diagnose(sensors, 100.0), Level::OK, {});
  sensors[1].topic = "/range/left";
  expectSays(diagnose(sensors, 100.0), Level::WARN, {"/range/left, /sonar", "same frame front"});
  sensors[0].frame = "base_link";
  expectSays(diagnose(sensors, 100.0), Level::WARN, {"/sonar", "the frame of the robot itself"});
  sensors[0].is_of_ring = true;
  expectSays(diagnose(sensors, 100.0), Level::OK, {});
  sensors[0].is_of_ring = false;
  sensors[0].silent = seconds(60);
  expectSays(diagnose(sensors, 100.0), Level::OK, {});
}

TEST_F(DiagnoseTransforms, SaysWhatWasLeftOut) {
  add("odom", "base_link", 100.0, false);
  left_out_ = {12, "transform from base_link to odom left out: it is stamped 20.0 s ahead"};
  expectSays(diagnose({}, 100.0), Level::WARN, {"base_link to odom", "20.0 s ahead"});
}

}  // namespace
}  // namespace place_memory::node
