#include "core/explore/heard_walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_memory::core {
namespace {

constexpr double kNoEcho = std::numeric_limits<double>::infinity();

class HeardWallsTest : public testing::Test {
 protected:
  /// The sonar stands so far west of the origin and looks east, or beside that by `bearing` [rad].
  void hear(double off, double range, int times, double bearing = 0.0) {
    for (int i = 0; i < times; ++i) {
      walls_.add(Pose2d{-off * std::cos(bearing), -off * std::sin(bearing), bearing}, {}, range);
    }
  }

  HeardWalls walls_{0.1};
};

TEST_F(HeardWallsTest, AWallStandsWhoeverElseLooksPastIt) {
  hear(1.0, 1.05, 3);
  EXPECT_TRUE(walls_.isWall(0.05, 0.0));
  hear(1.0, kNoEcho, 9, 1.2);
  EXPECT_TRUE(walls_.isWall(0.05, 0.0));
}

TEST_F(HeardWallsTest, WhatEchoedFromAfarOnlyIsNoWall) {
  hear(2.0, 2.05, 20);
  EXPECT_TRUE(walls_.isWall(0.05, 0.0));
  hear(0.7, kNoEcho, 3);
  EXPECT_FALSE(walls_.isWall(0.05, 0.0));
}

TEST_F(HeardWallsTest, FromNearItIsFoundOpenUnderAnotherBearingToo) {
  hear(2.0, 2.05, 20, 0.6);
  ASSERT_TRUE(walls_.isWall(0.05, 0.05));
  hear(0.7, kNoEcho, 3, 0.3);
  EXPECT_FALSE(walls_.isWall(0.05, 0.05));
}

TEST_F(HeardWallsTest, WhatEchoedFromNearIsNotTakenBackFromAfar) {
  hear(0.7, 0.75, 3);
  hear(2.4, kNoEcho, 20);
  EXPECT_TRUE(walls_.isWall(0.05, 0.0));
}

}  // namespace
}  // namespace place_memory::core
