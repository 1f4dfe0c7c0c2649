#include "core/sensing/compass_offset.h"

#include <gtest/gtest.h>

#include <cmath>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

using std::chrono::milliseconds;

std::optional<double> unknown(std::chrono::nanoseconds /*stamp*/) { return std::nullopt; }

CompassOffset::YawAt always(double yaw) {
  return [yaw](std::chrono::nanoseconds) { return yaw; };
}

TEST(CompassOffset, IsUnknownWithoutAHeading) {
  CompassOffset offset;
  offset.process(milliseconds(1000), always(0.3));
  EXPECT_FALSE(offset.mean());
}

TEST(CompassOffset, IsTheMeanAcrossTheHalfTurn) {
  CompassOffset offset;
  offset.add(milliseconds(1000), milliseconds(2000), kPi - 0.1);
  offset.add(milliseconds(1100), milliseconds(2000), -kPi + 0.3);
  offset.process(milliseconds(1200), always(0.0));
  ASSERT_TRUE(offset.mean());
  EXPECT_NEAR(std::remainder(*offset.mean() - (kPi + 0.1), 2.0 * kPi), 0.0, 1e-9);
}

TEST(CompassOffset, AHeadingWaitsForOdometryUntilItsDeadline) {
  CompassOffset offset;
  offset.add(milliseconds(1000), milliseconds(2000), 0.5);
  offset.process(milliseconds(1900), unknown);
  EXPECT_FALSE(offset.mean());
  offset.process(milliseconds(1950), always(0.2));
  ASSERT_TRUE(offset.mean());
  EXPECT_NEAR(*offset.mean(), 0.3, 1e-9);

  CompassOffset late;
  late.add(milliseconds(1000), milliseconds(2000), 0.5);
  late.process(milliseconds(2000), unknown);
  late.process(milliseconds(2100), always(0.2));
  EXPECT_FALSE(late.mean());
}

TEST(CompassOffset, AHeadingThatIsNoLongerWaitedForIsForgotten) {
  CompassOffset offset;
  offset.add(milliseconds(1000), milliseconds(2000), 0.5);
  offset.clearWaiting();
  offset.process(milliseconds(1100), always(0.2));
  EXPECT_FALSE(offset.mean());
}

TEST(CompassOffset, AHeadingCountsOnce) {
  CompassOffset offset;
  offset.add(milliseconds(1000), milliseconds(2000), 0.5);
  offset.process(milliseconds(1100), always(0.0));
  offset.add(milliseconds(1200), milliseconds(2000), 0.1);
  offset.process(milliseconds(1300), always(0.0));
  ASSERT_TRUE(offset.mean());
  EXPECT_NEAR(*offset.mean(), 0.3, 1e-9);
}

}  // namespace
}  // namespace place_memory::core
