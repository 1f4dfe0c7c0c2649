#include "core/drive/lost_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace place_memory::core {
namespace {

using std::chrono::seconds;

/// What a ring of sixteen sonars hears that has so much room ahead, to the left, behind and to the
/// right, and walls at right angles to that.
EchoRing ringWith(double ahead, double left, double behind, double right) {
  EchoRing ring{seconds(5)};
  for (SensorId sensor = 0; sensor < 16; ++sensor) {
    const double bearing = 2.0 * kPi * static_cast<double>(sensor) / 16.0;
    const double x = std::cos(bearing), y = std::sin(bearing);
    const double along = x > 1e-9 ? ahead / x : x < -1e-9 ? behind / -x : 1e9;
    const double across = y > 1e-9 ? left / y : y < -1e-9 ? right / -y : 1e9;
    const double range = std::min(along, across);
    ring.hear(sensor, seconds(0), {0.0, 0.0, bearing},
              range < 5.0 ? range : std::numeric_limits<double>::infinity());
  }
  return ring;
}

class LostSearchTest : public testing::Test {
 protected:
  LostSearchTest() { search_.follow({}, seconds(0)); }

  LostSearchOptions options_;
  LostSearch search_{options_};
};

TEST_F(LostSearchTest, DrivesWhereThereIsRoom) {
  search_.decide({}, ringWith(0.6, 0.6, 4.0, 0.6), seconds(0));
  ASSERT_TRUE(search_.target());
  EXPECT_LT(search_.target()->x, -1.0);
  EXPECT_NEAR(search_.target()->y, 0.0, 0.4);
  EXPECT_GE(search_.target()->x, -options_.step - 1e-9);
  EXPECT_FALSE(search_.isAdvised());
}

TEST_F(LostSearchTest, KeepsClearOfWhatItHears) {
  search_.decide({}, ringWith(1.8, 0.5, 0.5, 0.5), seconds(0));
  ASSERT_TRUE(search_.target());
  EXPECT_GT(search_.target()->x, 0.5);
  EXPECT_LT(search_.target()->x, 1.8 - options_.radius - options_.clearance);
}

TEST_F(LostSearchTest, GoesOnRatherThanBackToWhereItWas) {
  const EchoRing corridor = ringWith(4.0, 0.8, 4.0, 0.8);
  for (int i = 1; i <= 3; ++i) {
    search_.decide({}, corridor, seconds(0));
    ASSERT_TRUE(search_.target());
    EXPECT_NEAR(search_.target()->x, 2.0 * i, 0.6);
    search_.follow({2.0 * i - 1.0, 0.0, 0.0}, seconds(4 * i));
    search_.follow({2.0 * i, 0.0, 0.0}, seconds(4 * i + 2));
    search_.arrived();
    EXPECT_FALSE(search_.target());
  }
}

TEST_F(LostSearchTest, WhatIsAdvisedComesFirstUnlessItIsBarred) {
  const EchoRing open = ringWith(4.0, 4.0, 4.0, 4.0);
  const std::vector<Pose2d> advised{{0.0, 3.0, 0.0}, {0.0, 6.0, 0.0}};
  search_.decide(advised, open, seconds(0));
  EXPECT_TRUE(search_.isAdvised());
  EXPECT_EQ(*search_.target(), advised[0]);
  search_.blocked();
  EXPECT_FALSE(search_.target());
  search_.decide(advised, open, seconds(0));
  EXPECT_FALSE(search_.isAdvised());
  ASSERT_TRUE(search_.target());
  EXPECT_GT(std::hypot(search_.target()->x, search_.target()->y - 3.0), 0.6);
}

TEST_F(LostSearchTest, WhereNoWayLeadsOnThereIsNoTarget) {
  search_.decide({}, ringWith(0.6, 0.6, 0.6, 0.6), seconds(0));
  EXPECT_FALSE(search_.target());
  EXPECT_FALSE(search_.isOver());
}

TEST_F(LostSearchTest, WhereNoSonarLooksItGoesLittle) {
  EchoRing ahead{seconds(5)};
  ahead.hear(0, seconds(0), {}, 0.5);
  search_.decide({}, ahead, seconds(0));
  ASSERT_TRUE(search_.target());
  EXPECT_LE(std::hypot(search_.target()->x, search_.target()->y), 0.7);
}

TEST_F(LostSearchTest, EndsByItsWayAndByItsTime) {
  search_.follow({0.9 * options_.most_way, 0.0, 0.0}, seconds(10));
  EXPECT_FALSE(search_.isOver());
  search_.pause();
  search_.follow({-100.0, 0.0, 0.0}, seconds(1000));  // meanwhile it knew where it was
  EXPECT_FALSE(search_.isOver());
  EXPECT_NEAR(search_.way(), 0.9 * options_.most_way, 1e-9);
  LostSearch late = search_;
  late.follow({-100.0, 0.0, 0.0}, seconds(1000) + seconds(200));
  EXPECT_TRUE(late.isOver());
  search_.follow({-100.0, 5.0, 0.0}, seconds(1010));
  EXPECT_TRUE(search_.isOver());
}

}  // namespace
}  // namespace place_memory::core
