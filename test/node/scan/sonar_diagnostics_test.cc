#include "node/scan/sonar_diagnostics.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;
using Sensors = std::map<std::string, SensorHealth>;

SensorHealth sound() {
  SensorHealth sensor;
  sensor.messages = 10;
  sensor.last_received = ros::Time(99.0);
  return sensor;
}

diagnostic_updater::DiagnosticStatusWrapper diagnose(const Sensors& sensors) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  diagnoseSonars(sensors, ros::Time(100.0), status);
  return status;
}

TEST(DiagnoseSonars, WithoutASensorItWarns) { EXPECT_EQ(diagnose({}).level, Level::WARN); }

TEST(DiagnoseSonars, SoundSensorsAreOk) {
  EXPECT_EQ(diagnose({{"a", sound()}, {"b", sound()}}).level, Level::OK);
}

TEST(DiagnoseSonars, ASensorWhoseLimitsMakeNoSenseIsAnErrorThatNamesIt) {
  SensorHealth bad = sound();
  bad.sensor_problem = "field_of_view must be in (0, pi] rad, not -1";
  const auto status = diagnose({{"a", sound()}, {"left", bad}});
  EXPECT_EQ(status.level, Level::ERROR);
  EXPECT_NE(status.message.find("left: field_of_view"), std::string::npos) << status.message;
}

TEST(DiagnoseSonars, ASilentSensorIsAWarning) {
  SensorHealth silent = sound();
  silent.last_received = ros::Time(90.0);
  const auto status = diagnose({{"a", sound()}, {"rear", silent}});
  EXPECT_EQ(status.level, Level::WARN);
  EXPECT_NE(status.message.find("rear: silent"), std::string::npos) << status.message;
}

TEST(DiagnoseSonars, ASensorOfWhichNothingIsUsedIsAWarning) {
  SensorHealth useless = sound();
  useless.rejected.at(static_cast<std::size_t>(Reject::kNan)) = 10;
  const auto status = diagnose({{"a", useless}});
  EXPECT_EQ(status.level, Level::WARN);
  ASSERT_EQ(status.values.size(), 1U);
  EXPECT_EQ(status.values[0].key, "a");
  EXPECT_EQ(status.values[0].value, "10 messages, 10 range is NaN");
}

}  // namespace
}  // namespace place_memory::node
