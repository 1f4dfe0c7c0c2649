#include "node/input/range_adapter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>

namespace place_memory::node {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

sensor_msgs::Range message(float range) {
  sensor_msgs::Range m;
  m.header.frame_id = "sonar_0";
  m.header.stamp = ros::Time(10.0);
  m.field_of_view = 0.4F;
  m.min_range = 0.15F;
  m.max_range = 4.5F;
  m.range = range;
  return m;
}

AdaptedReading adapt(const sensor_msgs::Range& m, bool over_range_is_no_echo = false) {
  SensorRegistry registry;
  config::Parameters parameters;
  parameters.scan.over_range_is_no_echo = over_range_is_no_echo;
  return RangeAdapter("/sonar", parameters, registry).adapt(m);
}

TEST(RangeAdapter, SaysWhereItsMeasurementIsFrom) {
  SensorRegistry registry;
  const config::Parameters parameters;
  RangeAdapter adapter("/sonar", parameters, registry);
  const core::Measurement measurement = adapter.adapt(message(1.0F)).measurement;
  EXPECT_EQ(measurement.stamp, std::chrono::seconds(10));
  EXPECT_EQ(measurement.frame, "sonar_0");
  EXPECT_EQ(measurement.sensor, registry.idOf("/sonar", "sonar_0"));
  EXPECT_EQ(measurement.frame_from_sensor.x, 0.0);
  EXPECT_EQ(measurement.frame_from_sensor.yaw, 0.0);
}

TEST(RangeAdapter, ARejectedMeasurementStillSaysWhoseItIs) {
  SensorRegistry registry;
  const config::Parameters parameters;
  RangeAdapter adapter("/sonar", parameters, registry);
  const AdaptedReading reading = adapter.adapt(message(kNan));
  EXPECT_EQ(reading.reject, Reject::kNan);
  EXPECT_EQ(reading.measurement.sensor, registry.idOf("/sonar", "sonar_0"));
  EXPECT_EQ(reading.measurement.stamp, std::chrono::seconds(10));
}

TEST(RangeAdapter, ZeroBelowMinRangeIsWhatTheParameterSays) {
  SensorRegistry registry;
  config::Parameters parameters;
  RangeAdapter adapter("/sonar", parameters, registry);
  EXPECT_EQ(adapter.adapt(message(0.0F)).reject, Reject::kBelowMinRange);
  parameters.scan.zero_range_is_no_echo = true;
  EXPECT_FALSE(adapter.adapt(message(0.0F)).reject);
  EXPECT_EQ(adapter.adapt(message(0.0F)).measurement.range, kInf);
  EXPECT_EQ(adapter.adapt(message(0.1F)).reject, Reject::kBelowMinRange);
}

TEST(RangeAdapter, TakesAnEchoWithinTheLimits) {
  for (const float range : {0.15F, 1.0F, 4.49F}) {
    const AdaptedReading checked = adapt(message(range), false);
    EXPECT_FALSE(checked.reject) << range;
    EXPECT_EQ(checked.measurement.range, static_cast<double>(range));
    EXPECT_EQ(checked.measurement.spec.min_range, static_cast<double>(0.15F));
    EXPECT_EQ(checked.measurement.spec.max_range, 4.5);
    EXPECT_EQ(checked.measurement.spec.field_of_view, static_cast<double>(0.4F));
  }
}

TEST(RangeAdapter, InfinityIsNoEcho) {
  const AdaptedReading checked = adapt(message(kInf), false);
  EXPECT_FALSE(checked.reject);
  EXPECT_EQ(checked.measurement.range, std::numeric_limits<double>::infinity());
}

struct Bad {
  const char* what;
  float range;
  Reject reject;
};

std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.what; }

class BadRange : public testing::TestWithParam<Bad> {};

TEST_P(BadRange, IsRejectedWithItsReason) {
  EXPECT_EQ(adapt(message(GetParam().range), false).reject, GetParam().reject);
}

INSTANTIATE_TEST_SUITE_P(RangeAdapter, BadRange,
                         testing::Values(Bad{"NaN", kNan, Reject::kNan},
                                         Bad{"-inf", -kInf, Reject::kTooClose},
                                         Bad{"below min", 0.149F, Reject::kBelowMinRange},
                                         Bad{"zero", 0.0F, Reject::kBelowMinRange},
                                         Bad{"negative", -0.5F, Reject::kBelowMinRange},
                                         Bad{"above max", 4.6F, Reject::kAboveMaxRange},
                                         Bad{"far above max", 1e30F, Reject::kAboveMaxRange}));

TEST(RangeAdapter, OverRangeMayBeTakenForNoEcho) {
  const AdaptedReading checked = adapt(message(5.0F), true);
  EXPECT_FALSE(checked.reject);
  EXPECT_EQ(checked.measurement.range, std::numeric_limits<double>::infinity());
  EXPECT_EQ(adapt(message(kNan), true).reject, Reject::kNan);
  EXPECT_EQ(adapt(message(-kInf), true).reject, Reject::kTooClose);
}

TEST(RangeAdapter, OfAFixedDistanceSensorOnlyTheInfinitiesCount) {
  sensor_msgs::Range m = message(0.5F);
  m.min_range = m.max_range = 0.5F;
  EXPECT_EQ(adapt(m, true).reject, Reject::kFixedDistance);
  m.range = -kInf;
  EXPECT_EQ(adapt(m, true).reject, Reject::kTooClose);
  m.range = kInf;
  const AdaptedReading checked = adapt(m, false);
  EXPECT_FALSE(checked.reject);
  EXPECT_LT(checked.measurement.spec.min_range, checked.measurement.spec.max_range);
  EXPECT_EQ(checked.measurement.spec.max_range, 0.5);
}

TEST(RangeAdapter, NeedsAStamp) {
  sensor_msgs::Range m = message(1.0F);
  m.header.stamp = ros::Time();
  EXPECT_EQ(adapt(m, false).reject, Reject::kNoStamp);
}

struct BadLimits {
  std::string frame;
  float fov;
  float min;
  float max;
  const char* problem;
};

std::ostream& operator<<(std::ostream& out, const BadLimits& bad) { return out << bad.problem; }

class BadSensor : public testing::TestWithParam<BadLimits> {};

TEST_P(BadSensor, IsRejectedWithASentence) {
  sensor_msgs::Range m = message(1.0F);
  m.header.frame_id = GetParam().frame;
  m.field_of_view = GetParam().fov;
  m.min_range = GetParam().min;
  m.max_range = GetParam().max;
  EXPECT_EQ(adapt(m, false).reject, Reject::kBadSensor);
  const std::string problem = adapt(m).sensor_problem;
  EXPECT_NE(problem.find(GetParam().problem), std::string::npos) << problem;
}

INSTANTIATE_TEST_SUITE_P(
    RangeAdapter, BadSensor,
    testing::Values(BadLimits{"", 0.4F, 0.1F, 4.0F, "frame_id is empty"},
                    BadLimits{"a\nb", 0.4F, 0.1F, 4.0F, "control characters"},
                    BadLimits{std::string(257, 'a'), 0.4F, 0.1F, 4.0F, "257 bytes"},
                    BadLimits{"s", 0.0F, 0.1F, 4.0F, "field_of_view"},
                    BadLimits{"s", -0.4F, 0.1F, 4.0F, "field_of_view"},
                    BadLimits{"s", 3.15F, 0.1F, 4.0F, "field_of_view"},
                    BadLimits{"s", kNan, 0.1F, 4.0F, "field_of_view"},
                    BadLimits{"s", kInf, 0.1F, 4.0F, "field_of_view"},
                    BadLimits{"s", 0.4F, -0.1F, 4.0F, "min_range must be finite"},
                    BadLimits{"s", 0.4F, kNan, 4.0F, "min_range must be finite"},
                    BadLimits{"s", 0.4F, kInf, 4.0F, "min_range must be finite"},
                    BadLimits{"s", 0.4F, 0.1F, kNan, "max_range must be finite"},
                    BadLimits{"s", 0.4F, 0.1F, kInf, "max_range must be finite"},
                    BadLimits{"s", 0.4F, 0.0F, 0.0F, "max_range must be finite and positive"},
                    BadLimits{"s", 0.4F, 4.1F, 4.0F, "min_range must not exceed max_range"}));

TEST(RangeAdapter, TakesAHalfCircleAsAFloat) {
  sensor_msgs::Range m = message(1.0F);
  m.field_of_view = static_cast<float>(M_PI);
  EXPECT_EQ(adapt(m).sensor_problem, "");
  EXPECT_LE(adapt(m).measurement.spec.field_of_view, M_PI);
}

TEST(Reject, EveryReasonHasItsWords) {
  for (std::size_t i = 0; i < kRejects; ++i) {
    EXPECT_GT(std::string(toString(static_cast<Reject>(i))).size(), 0U);
    EXPECT_GT(std::string(adviceOn(static_cast<Reject>(i))).size(), 0U);
  }
}

}  // namespace
}  // namespace place_memory::node
