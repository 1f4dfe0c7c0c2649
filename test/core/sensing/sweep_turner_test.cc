#include "core/sensing/sweep_turner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr double kStep = kPi / 90.0;
constexpr double kMaxRate = 0.2;
constexpr double kPeriod = 0.05;

// A robot that does what it is told, and how far it got.
struct Ride {
  double yaw;
  double least = 0.0;
  double most = 0.0;
  int updates = 0;
  int completed = 0;
};

// Each heading is over after five updates at it.
Ride ride(int headings, double step, double start, int most_updates = 20000) {
  SweepTurner turner(headings, step, kMaxRate);
  Ride ride{start};
  double turned = 0.0;
  int there = 0;
  while (!turner.done() && ride.updates < most_updates) {
    const double rate = turner.update(wrapAngle(ride.yaw), ride.completed);
    EXPECT_LE(std::abs(rate), kMaxRate);
    ++ride.updates;
    turned += rate * kPeriod;
    ride.yaw = start + turned;
    ride.least = std::min(ride.least, turned);
    ride.most = std::max(ride.most, turned);
    there = turner.started() && rate == 0.0 ? there + 1 : 0;
    if (there == 5) {
      ++ride.completed;
      there = 0;
    }
  }
  EXPECT_TRUE(turner.done());
  return ride;
}

TEST(SweepTurner, SweepsEvenlyAboutWhereItBeganAndComesBack) {
  const Ride r = ride(11, kStep, 3.1);
  EXPECT_NEAR(r.least, -5 * kStep, 0.02);
  EXPECT_NEAR(r.most, 5 * kStep, 0.02);
  EXPECT_NEAR(r.yaw, 3.1, 0.01);
  EXPECT_EQ(r.completed, 11);
}

TEST(SweepTurner, GoesThroughAFullTurnAndEndsWhereItBegan) {
  const Ride r = ride(72, kPi / 36.0, -2.0);
  EXPECT_GE(r.least, -0.02);
  EXPECT_NEAR(r.most, 2.0 * kPi, 0.1);
  EXPECT_NEAR(wrapAngle(r.yaw + 2.0), 0.0, 0.01);
}

TEST(SweepTurner, StepsSmallerThanARobotCanTurnComeToAnEnd) {
  for (const double step : {0.001, 0.002, 0.003, 0.005}) {
    EXPECT_NEAR(ride(5, step, 0.4, 2000).yaw, 0.4, 0.005) << step;
  }
}

TEST(SweepTurner, ASingleHeadingNeedsNoTurn) {
  const Ride r = ride(1, kStep, 0.7);
  EXPECT_EQ(r.yaw, 0.7);
}

TEST(SweepTurner, StaysAtAHeadingThatIsNotOver) {
  SweepTurner turner(11, kStep, kMaxRate);
  double yaw = 0.0;
  for (int i = 0; i < 2000; ++i) yaw += kPeriod * turner.update(yaw, 3);
  EXPECT_TRUE(turner.started());
  EXPECT_FALSE(turner.swept());
  EXPECT_NEAR(yaw, -2 * kStep, 0.01);
}

TEST(SweepTurner, CorrectsARobotThatOvershoots) {
  SweepTurner turner(1, kStep, kMaxRate);
  EXPECT_EQ(turner.update(1.0, 0), 0.0);
  EXPECT_LT(turner.update(1.1, 0), 0.0);
  EXPECT_GT(turner.update(0.9, 0), 0.0);
}

}  // namespace
}  // namespace place_memory::core
