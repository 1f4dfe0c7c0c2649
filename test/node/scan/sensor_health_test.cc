#include "node/scan/sensor_health.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

class SensorHealthTest : public testing::Test {
 protected:
  core::SensorId hear(const std::string& frame, nanoseconds now,
                      const std::string& topic = "/sonar") {
    AdaptedReading reading;
    reading.measurement.sensor = registry_.idOf(topic, frame);
    reading.sensor_problem = problem_;
    reading.unit_problem = unit_problem_;
    table_.noteMessage(reading, now);
    return reading.measurement.sensor;
  }

  std::vector<std::string> names(nanoseconds now) const {
    std::vector<std::string> names;
    for (const SensorHealth& sensor : table_.report(registry_, now)) names.push_back(sensor.name);
    return names;
  }

  SensorHealth only(nanoseconds now) const {
    const auto report = table_.report(registry_, now);
    EXPECT_EQ(report.size(), 1U);
    return report.at(0);
  }

  SensorRegistry registry_;
  SensorHealthTable table_;
  std::string problem_;
  std::string unit_problem_;
};

using Names = std::vector<std::string>;

TEST_F(SensorHealthTest, HoldsABoundedNumberOfSensors) {
  for (std::size_t i = 0; i < 10 * SensorRegistry::kMaxSensors; ++i) {
    hear("frame_" + std::to_string(i), seconds(1));
  }
  const auto report = table_.report(registry_, seconds(1));
  EXPECT_EQ(report.size(), SensorRegistry::kMaxSensors + 1);
  EXPECT_EQ(report.front().frame, "") << "of many frames none is to be looked up";
}

TEST_F(SensorHealthTest, KeepsWhatIsWrongWithASensor) {
  problem_ = "field_of_view must be in (0, pi] rad, not -1";
  hear("sonar_0", seconds(1));
  EXPECT_EQ(only(seconds(1)).sensor_problem, problem_);
  problem_.clear();
  hear("sonar_0", seconds(2));
  EXPECT_EQ(only(seconds(2)).sensor_problem, "");
}

TEST_F(SensorHealthTest, KeepsWhatIsWrongWithItsUnits) {
  unit_problem_ = "sonar_0 has a max_range of 457 m";
  hear("sonar_0", seconds(1));
  EXPECT_EQ(only(seconds(1)).unit_problem, unit_problem_);
  unit_problem_.clear();
  hear("sonar_0", seconds(2));
  EXPECT_EQ(only(seconds(2)).unit_problem, "");
}

TEST_F(SensorHealthTest, CountsTheLastTenSeconds) {
  for (int second = 0; second < 100; ++second) hear("sonar_0", seconds(second));
  const core::SensorId id = registry_.idOf("/sonar", "sonar_0");
  for (int second = 100; second < 105; ++second) {
    hear("sonar_0", seconds(second));
    table_.noteReject(id, Reject::kNan, seconds(second));
  }
  const SensorHealth health = only(seconds(104));
  EXPECT_EQ(health.messages, 10U);
  EXPECT_EQ(health.rejected.at(static_cast<std::size_t>(Reject::kNan)), 5U);
  EXPECT_EQ(only(seconds(200)).rejected, RejectCounts{});
  EXPECT_EQ(only(seconds(200)).silent, seconds(96));
}

TEST_F(SensorHealthTest, KnowsWhoWasHeardLately) {
  const core::SensorId late = hear("sonar_0", seconds(10));
  const core::SensorId early = hear("sonar_1", seconds(8));
  const auto heard = table_.heardWithin(seconds(2), seconds(10));
  EXPECT_EQ(heard.count(late), 1U);
  EXPECT_EQ(heard.count(early), 0U);
}

TEST_F(SensorHealthTest, ASensorWhoseFrameWasCorrectedDoesNotStayListed) {
  hear("wrong", seconds(1));
  hear("right", seconds(2));
  EXPECT_EQ(names(seconds(6)), (Names{"wrong", "right"}));
  hear("right", milliseconds(6500));
  EXPECT_EQ(names(milliseconds(6500)), (Names{"right"}));
}

TEST_F(SensorHealthTest, ASensorThatFellSilentStaysListed) {
  hear("left", seconds(1));
  hear("right", seconds(1));
  hear("front", seconds(2), "/front");
  hear("right", seconds(30));
  EXPECT_EQ(names(seconds(30)), (Names{"left", "right", "front"}))
      << "neither one that was heard before nor one on another topic stands in for it";
}

}  // namespace
}  // namespace place_memory::node
