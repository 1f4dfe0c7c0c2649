#include "core/mapping/seen_middle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::core {
namespace {

/// Sonars of a base at `base`, from one bearing to another, in a hall of which only the walls
/// x = -4 and x = 4 are near enough to echo.
std::vector<SonarReading> seenFrom(const Pose2d& base, double first, double last) {
  std::vector<SonarReading> readings;
  for (int i = 0; i < 8; ++i) {
    const double bearing = first + (last - first) * i / 8.0;
    const double along = std::cos(base.yaw + bearing);
    const double range =
        std::abs(along) < 0.1 ? 4.0 : ((along > 0.0 ? 4.0 : -4.0) - base.x) / along;
    readings.push_back({{0.0, 0.0, bearing}, {0.4, 0.1, 4.5}, std::min(range, 4.5)});
  }
  return readings;
}

TEST(SeenMiddle, IsTheBaseWhereSonarsLookAllWays) {
  for (const double x : {0.0, 1.0, 3.0}) {
    const Pose2d middle = seenMiddle(seenFrom({x, 0.0, 0.0}, 0.0, 2.0 * kPi));
    EXPECT_EQ(middle.x, 0.0);
    EXPECT_EQ(middle.y, 0.0);
  }
  EXPECT_EQ(seenMiddle({}).x, 0.0);
}

TEST(SeenMiddle, LiesBeforeABaseWhoseSonarsLookAhead) {
  const Pose2d middle = seenMiddle(seenFrom({0.0, 0.0, 0.0}, -0.6, 0.75));
  EXPECT_GT(middle.x, 1.0);
  EXPECT_LT(middle.x, 2.25);
  EXPECT_NEAR(middle.y, 0.0, 0.3);
  EXPECT_EQ(middle.yaw, 0.0);
}

TEST(SeenMiddle, IsNearForRobotsThatFaceEachOtherAcrossIt) {
  const Pose2d one{-2.1, 0.0, 0.0}, other{2.1, 0.0, kPi};
  const Pose2d a = one * seenMiddle(seenFrom(one, -0.6, 0.75));
  const Pose2d b = other * seenMiddle(seenFrom(other, -0.6, 0.75));
  EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 0.6);
}

}  // namespace
}  // namespace place_memory::core
