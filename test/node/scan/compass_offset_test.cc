#include "node/scan/compass_offset.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::node {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::optional<double> unknown(const ros::Time& /*stamp*/) { return std::nullopt; }

CompassOffset::YawAt always(double yaw) {
  return [yaw](const ros::Time&) { return yaw; };
}

TEST(CompassOffset, IsUnknownWithoutAHeading) {
  CompassOffset offset;
  offset.process(ros::Time(1.0), always(0.3));
  EXPECT_FALSE(offset.mean());
}

TEST(CompassOffset, IsTheMeanAcrossTheHalfTurn) {
  CompassOffset offset;
  offset.add(ros::Time(1.0), ros::Time(2.0), kPi - 0.1);
  offset.add(ros::Time(1.1), ros::Time(2.0), -kPi + 0.3);
  offset.process(ros::Time(1.2), always(0.0));
  ASSERT_TRUE(offset.mean());
  EXPECT_NEAR(std::remainder(*offset.mean() - (kPi + 0.1), 2.0 * kPi), 0.0, 1e-9);
}

TEST(CompassOffset, AHeadingWaitsForOdometryUntilItsDeadline) {
  CompassOffset offset;
  offset.add(ros::Time(1.0), ros::Time(2.0), 0.5);
  offset.process(ros::Time(1.9), unknown);
  EXPECT_FALSE(offset.mean());
  offset.process(ros::Time(1.95), always(0.2));
  ASSERT_TRUE(offset.mean());
  EXPECT_NEAR(*offset.mean(), 0.3, 1e-9);

  CompassOffset late;
  late.add(ros::Time(1.0), ros::Time(2.0), 0.5);
  late.process(ros::Time(2.0), unknown);
  late.process(ros::Time(2.1), always(0.2));
  EXPECT_FALSE(late.mean());
}

}  // namespace
}  // namespace place_memory::node
