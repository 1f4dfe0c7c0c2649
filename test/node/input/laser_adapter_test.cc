#include "node/input/laser_adapter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_memory::node {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

sensor_msgs::LaserScan scanOf(std::size_t beams, float range) {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = ros::Time(10.0);
  scan.header.frame_id = "/laser";
  scan.angle_min = -1.5F;
  scan.angle_max = 1.5F;
  scan.angle_increment = 3.0F / static_cast<float>(beams - 1);
  scan.range_min = 0.1F;
  scan.range_max = 10.0F;
  scan.ranges.assign(beams, range);
  return scan;
}

class LaserAdapterTest : public testing::Test {
 protected:
  std::vector<AdaptedReading> adapt(const sensor_msgs::LaserScan& scan) {
    return LaserAdapter("/scan", parameters_, registry_).adapt(scan);
  }

  config::Parameters parameters_;
  SensorRegistry registry_;
};

TEST_F(LaserAdapterTest, IsThinnedToConesThatTileItsView) {
  parameters_.laser.cones = 30;
  const auto readings = adapt(scanOf(301, 2.0F));
  ASSERT_EQ(readings.size(), 30U);
  double before = -1.5 - 0.1;
  for (const AdaptedReading& reading : readings) {
    EXPECT_FALSE(reading.reject);
    EXPECT_EQ(reading.measurement.frame, "laser");
    EXPECT_NEAR(reading.measurement.range, 2.0, 1e-6);
    EXPECT_NEAR(reading.measurement.spec.field_of_view, 0.1, 0.01);
    EXPECT_NEAR(reading.measurement.frame_from_sensor.yaw - before, 0.1, 0.06);
    before = reading.measurement.frame_from_sensor.yaw;
  }
}

TEST_F(LaserAdapterTest, AConeHearsTheNearestOfItsBeams) {
  parameters_.laser.cones = 1;
  sensor_msgs::LaserScan scan = scanOf(5, kInf);
  EXPECT_EQ(adapt(scan).front().measurement.range, kInf);
  scan.ranges[1] = 3.0F;
  scan.ranges[3] = 2.0F;
  scan.ranges[4] = std::nanf("");
  EXPECT_EQ(adapt(scan).front().measurement.range, 2.0);
  EXPECT_FALSE(adapt(scan).front().reject);
}

TEST_F(LaserAdapterTest, AConeWithoutAUsableBeamIsCounted) {
  parameters_.laser.cones = 2;
  sensor_msgs::LaserScan scan = scanOf(4, std::nanf(""));
  scan.ranges[3] = 1.0F;
  const auto readings = adapt(scan);
  EXPECT_EQ(readings[0].reject, Reject::kNan);
  EXPECT_FALSE(readings[1].reject);
}

TEST_F(LaserAdapterTest, MaxRangeIsNoEcho) {
  parameters_.laser.cones = 1;
  EXPECT_EQ(adapt(scanOf(3, 10.0F)).front().measurement.range, kInf);
  parameters_.no_echo.top = false;
  EXPECT_EQ(adapt(scanOf(3, 10.0F)).front().measurement.range, 10.0);
}

TEST_F(LaserAdapterTest, AFanThatCannotBeIsNamed) {
  const auto expect = [&](const sensor_msgs::LaserScan& scan, const std::string& word) {
    const auto readings = adapt(scan);
    ASSERT_EQ(readings.size(), 1U) << word;
    EXPECT_EQ(readings.front().reject, Reject::kBadSensor) << word;
    EXPECT_NE(readings.front().sensor_problem.find(word), std::string::npos)
        << readings.front().sensor_problem;
  };
  sensor_msgs::LaserScan scan = scanOf(100, 1.0F);
  scan.angle_increment = 0.0F;
  expect(scan, "angle_increment");
  scan.angle_increment = std::nanf("");
  expect(scan, "angle_increment");
  scan = scanOf(100, 1.0F);
  scan.angle_increment = 1.0F;
  expect(scan, "degrees");
  scan = scanOf(100, 1.0F);
  scan.ranges.resize(50);
  expect(scan, "50 beams, but the angles say 100");
  scan.ranges.clear();
  expect(scan, "0 beams");
  scan = scanOf(100, 1.0F);
  scan.angle_max = kInf;
  expect(scan, "angle_max");
  scan = scanOf(100, 1.0F);
  scan.range_max = kInf;
  expect(scan, "max_range");
  scan = scanOf(100, 1.0F);
  scan.header.frame_id = "";
  expect(scan, "frame_id");
  scan.header.frame_id = "la\nser";
  expect(scan, "control characters");
}

TEST_F(LaserAdapterTest, OneBeamIsAScanToo) {
  sensor_msgs::LaserScan scan = scanOf(2, 1.0F);
  scan.ranges.resize(1);
  scan.angle_max = scan.angle_min;
  EXPECT_EQ(adapt(scan).size(), 1U);
}

}  // namespace
}  // namespace place_memory::node
