#include "core/sensing/compass_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr std::chrono::nanoseconds kBegin = std::chrono::seconds(50);

using At = std::function<double(double seconds)>;  // [rad]

CompassWatch watched(const At& heading, const At& yaw, double seconds) {
  CompassWatch watch;
  std::mt19937 rng(5);
  std::normal_distribution<double> noise(0.0, 0.03);
  for (int i = 0; i * 0.1 < seconds; ++i) {
    watch.add(kBegin + std::chrono::milliseconds(100) * i, wrapAngle(heading(0.1 * i) + noise(rng)),
              wrapAngle(yaw(0.1 * i)));
  }
  return watch;
}

double sweep(double t) { return 3.0 + 0.2 * std::sin(0.5 * t); }

TEST(CompassWatch, ACompassThatFollowsIsWell) {
  for (const double offset : {0.0, 2.5}) {
    const auto watch = watched([&](double t) { return sweep(t) + offset; }, sweep, 10.0);
    EXPECT_FALSE(watch.find(kBegin));
  }
}

TEST(CompassWatch, ACompassThatErrsWithTheHeadingIsWell) {
  for (double phase = 0.0; phase < 6.3; phase += 0.3) {
    const auto watch =
        watched([&](double t) { return sweep(t) + 0.5 * std::sin(sweep(t) + phase); }, sweep, 10.0);
    EXPECT_FALSE(watch.find(kBegin)) << phase;
  }
}

TEST(CompassWatch, TheyAgreeOnceTheyTurnedAlike) {
  EXPECT_TRUE(watched(sweep, sweep, 10.0).agree(kBegin));
  EXPECT_FALSE(watched([](double t) { return -sweep(t); }, sweep, 10.0).agree(kBegin));
  const At rest = [](double) { return 1.0; };
  EXPECT_FALSE(watched(rest, rest, 10.0).agree(kBegin)) << "nothing has turned";
}

TEST(CompassWatch, NamesACompassThatStandsStill) {
  const auto found = watched([](double) { return 1.0; }, sweep, 10.0).find(kBegin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fault, CompassWatch::Fault::kCompassStands);
  EXPECT_NEAR(found->compass, 0.0, 0.06);
  EXPECT_NEAR(found->odometry, 0.4, 0.05);
}

TEST(CompassWatch, NamesACompassThatTurnsTheOtherWay) {
  const auto found = watched([](double t) { return -sweep(t); }, sweep, 10.0).find(kBegin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fault, CompassWatch::Fault::kCompassOtherWay);
  EXPECT_NEAR(found->compass, -0.4, 0.06);
}

TEST(CompassWatch, AFullTurnAcrossPi) {
  const auto turn = [](double t) { return 0.5 * t; };
  EXPECT_FALSE(watched(turn, turn, 14.0).find(kBegin));
  const auto found = watched([](double t) { return -0.5 * t; }, turn, 14.0).find(kBegin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fault, CompassWatch::Fault::kCompassOtherWay);
}

TEST(CompassWatch, NamesOdometryThatStandsStill) {
  const auto found = watched(
                         sweep, [](double) { return 0.4; }, 10.0)
                         .find(kBegin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fault, CompassWatch::Fault::kOdometryStands);
}

TEST(CompassWatch, ACompassThatDriftsWhileTheRobotStandsIsNoTurn) {
  const auto drift = [](double t) { return 0.01 * t; };
  EXPECT_FALSE(watched(
                   drift, [](double) { return 0.4; }, 60.0)
                   .find(kBegin));
}

TEST(CompassWatch, OfARobotThatStandsNothingIsKnown) {
  EXPECT_FALSE(watched([](double) { return 1.0; }, [](double) { return 0.4; }, 10.0).find(kBegin));
  EXPECT_FALSE(CompassWatch().find(kBegin));
}

TEST(CompassWatch, WhatWasBeforeTimeWentBackIsForgotten) {
  auto watch = watched([](double) { return 1.0; }, sweep, 10.0);
  ASSERT_TRUE(watch.find(kBegin));
  watch.add(std::chrono::seconds(1), 1.0, 1.0);
  EXPECT_FALSE(watch.find(std::chrono::nanoseconds(0)));
}

}  // namespace
}  // namespace place_memory::core
