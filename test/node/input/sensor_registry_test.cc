#include "node/input/sensor_registry.h"

#include <gtest/gtest.h>

#include <set>

namespace place_memory::node {
namespace {

TEST(SensorRegistry, TheSameNamesAreTheSameSensor) {
  SensorRegistry registry;
  const core::SensorId left = registry.idOf("/sonar", "left");
  EXPECT_NE(left, kOtherSensors);
  EXPECT_EQ(registry.idOf("/sonar", "left"), left);
  EXPECT_NE(registry.idOf("/sonar", "right"), left);
  EXPECT_NE(registry.idOf("/rear/sonar", "left"), left);
  EXPECT_EQ(registry.frameOf(left), "left");
  EXPECT_EQ(registry.topicOf(left), "/sonar");
}

TEST(SensorRegistry, ASensorIsNamedByItsTopicWhereTheFrameDoesNotDo) {
  SensorRegistry registry;
  const core::SensorId left = registry.idOf("/sonar", "left");
  EXPECT_EQ(registry.nameOf(left), "left");
  registry.idOf("/rear", "left");
  EXPECT_EQ(registry.nameOf(left), "left on /sonar");
  EXPECT_NE(registry.nameOf(registry.idOf("/sonar", "")).find("/sonar"), std::string::npos);
}

TEST(SensorRegistry, SensorsWithoutNumberShareOne) {
  SensorRegistry registry;
  std::set<core::SensorId> ids;
  for (std::size_t i = 0; i < 2 * SensorRegistry::kMaxSensors; ++i) {
    ids.insert(registry.idOf("/sonar", std::to_string(i)));
  }
  EXPECT_EQ(ids.size(), SensorRegistry::kMaxSensors + 1);
  EXPECT_EQ(ids.count(kOtherSensors), 1U);
  EXPECT_NE(registry.nameOf(kOtherSensors), "");
}

}  // namespace
}  // namespace place_memory::node
