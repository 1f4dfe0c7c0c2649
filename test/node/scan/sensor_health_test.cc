#include "node/scan/sensor_health.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

const ros::Time kReceived(100.0);

TEST(SensorHealthTable, HoldsABoundedNumberOfFrames) {
  SensorHealthTable table;
  sensor_msgs::Range m;
  for (std::size_t i = 0; i < 10 * SensorHealthTable::kMaxSensors; ++i) {
    m.header.frame_id = "frame_" + std::to_string(i);
    table.noteMessage(m, kReceived);
  }
  EXPECT_EQ(table.sensors().size(), SensorHealthTable::kMaxSensors + 1);
}

TEST(SensorHealthTable, KeepsWhatIsWrongWithASensor) {
  SensorHealthTable table;
  sensor_msgs::Range m;
  m.header.frame_id = "sonar_0";
  m.field_of_view = -1.0F;
  table.noteMessage(m, kReceived);
  EXPECT_NE(table.sensors().at("sonar_0").sensor_problem, "");
  m.field_of_view = 0.4F;
  m.max_range = 1.0F;
  table.noteMessage(m, kReceived);
  EXPECT_EQ(table.sensors().at("sonar_0").sensor_problem, "");
}

}  // namespace
}  // namespace place_memory::node
