#include "core/mapping/moving_scan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mapping/dead_reckoning.h"

namespace place_memory::core {
namespace {

const SonarSpec kSpec{0.4, 0.1, 4.5};

/// A robot whose sonars look to these bearings.
struct Robot {
  std::vector<double> bearings;
  MovingScanBuilder builder;
  DeadReckoning reckoning;
  double t = 0.0;
  double x = 0.0;

  Robot(std::vector<double> looks, const MovingScanOptions& options)
      : bearings(std::move(looks)), builder(options) {}

  std::vector<MovingScan> go(double way, double step) {
    std::vector<MovingScan> scans;
    for (int i = 0; i < static_cast<int>(std::lround(way / step)); ++i) {
      x += step;
      fire(scans);
    }
    return scans;
  }
  std::vector<MovingScan> stand(int moments) {
    std::vector<MovingScan> scans;
    for (int i = 0; i < moments; ++i) fire(scans);
    return scans;
  }

 private:
  void fire(std::vector<MovingScan>& scans) {
    t += 0.1;
    const Pose2d odom{x, 0.0, 0.0};
    reckoning.add(odom, {});
    const std::chrono::nanoseconds stamp(std::llround(t * 1e9));
    for (const double bearing : bearings) {
      builder.add({stamp, odom, reckoning.pose(), reckoning.way(), reckoning.turn()},
                  {{0.0, 0.0, bearing}, kSpec, 2.0});
      while (const auto scan = builder.take()) scans.push_back(*scan);
    }
  }
};

std::vector<double> ring(int count, double from, double to) {
  std::vector<double> bearings;
  for (int i = 0; i < count; ++i) bearings.push_back(from + (to - from) * i / count);
  return bearings;
}

TEST(MovingScan, OneEachHalfMetreOverThreeMetresCentredOnTheirMiddle) {
  Robot robot(ring(8, 0.0, 2.0 * kPi), {});
  const std::vector<MovingScan> scans = robot.go(10.0, 0.04);
  ASSERT_GE(scans.size(), 16U);
  for (std::size_t i = 8; i < scans.size(); ++i) {
    EXPECT_NEAR(scans[i].last_way - scans[i - 1].last_way, 0.5, 0.05);
    EXPECT_NEAR(scans[i].last_way - scans[i].first_way, 3.0, 0.1);
    // Where it refers to is about the middle, and the readings lie about it.
    EXPECT_NEAR(scans[i].middle.way, 0.5 * (scans[i].first_way + scans[i].last_way), 0.4);
    double least = 1e9, most = -1e9;
    for (const SonarReading& reading : *scans[i].readings) {
      least = std::min(least, reading.sensor_pose.x);
      most = std::max(most, reading.sensor_pose.x);
    }
    EXPECT_NEAR(most - least, 3.0, 0.1);
    EXPECT_TRUE(scans[i].enough);
  }
}

TEST(MovingScan, SonarsThatAllLookAheadNeedALongerStretch) {
  Robot robot(ring(8, -0.5 * kPi, 0.5 * kPi), {});
  const std::vector<MovingScan> scans = robot.go(10.0, 0.04);
  EXPECT_NEAR(scans.back().last_way - scans.back().first_way, 6.0, 0.1);
}

TEST(MovingScan, TheStretchGrowsUntilThereAreReadingsEnough) {
  Robot robot(ring(9, -0.5 * kPi, 0.5 * kPi), {});
  const std::vector<MovingScan> scans = robot.go(20.0, 0.55);
  EXPECT_NEAR(scans.back().last_way - scans.back().first_way, 5.5, 0.6);
  EXPECT_GE(scans.back().readings->size(), 90U);
}

TEST(MovingScan, TooFastForItsSensorsIsSaid) {
  Robot robot({0.0, 2.0, 4.0}, {});
  const std::vector<MovingScan> scans = robot.go(20.0, 0.5);
  ASSERT_FALSE(scans.empty());
  for (const MovingScan& scan : scans) EXPECT_FALSE(scan.enough);
}

TEST(MovingScan, StandingMakesNoScansAndKeepsFewReadings) {
  Robot robot(ring(16, 0.0, 2.0 * kPi), {});
  robot.go(5.0, 0.04);
  EXPECT_TRUE(robot.stand(6000).empty());
  const std::vector<MovingScan> scans = robot.go(0.6, 0.04);
  ASSERT_FALSE(scans.empty());
  EXPECT_LT(scans.front().readings->size(), 16U * 80U + 100U);
}

TEST(MovingScan, AfterARestartNothingFromBeforeIsLeft) {
  Robot robot(ring(16, 0.0, 2.0 * kPi), {});
  robot.go(5.0, 0.04);
  const double way = robot.reckoning.way();
  robot.builder.restart();
  const std::vector<MovingScan> scans = robot.go(1.2, 0.04);
  ASSERT_FALSE(scans.empty());
  EXPECT_GE(scans.front().first_way, way);
}

TEST(MovingScan, RefersToWhereTheRobotTurnedLeast) {
  MovingScanBuilder builder({});
  DeadReckoning reckoning;
  double t = 0.0;
  Pose2d odom;
  std::vector<MovingScan> scans;
  for (int i = 0; i < 110; ++i) {
    t += 0.1;
    // Half a turn in six centimetres, about the middle of what will be the last stretch.
    const bool turns = i >= 72 && i < 75;
    odom = odom * Pose2d{turns ? 0.02 : 0.04, 0.0, turns ? kPi / 3.0 : 0.0};
    reckoning.add(odom, {});
    const std::chrono::nanoseconds stamp(std::llround(t * 1e9));
    for (const double bearing : ring(8, 0.0, 2.0 * kPi)) {
      builder.add({stamp, odom, reckoning.pose(), reckoning.way(), reckoning.turn()},
                  {{0.0, 0.0, bearing}, kSpec, 2.0});
      while (const auto scan = builder.take()) scans.push_back(*scan);
    }
  }
  for (const MovingScan& scan : scans) {
    const double second = std::chrono::duration<double>(scan.middle.stamp).count();
    EXPECT_FALSE(second > 7.25 && second < 7.55) << second;
  }
}

TEST(DeadReckoning, TremblingIsNoWay) {
  DeadReckoning reckoning;
  for (int i = 0; i < 1000; ++i) {
    reckoning.add({i % 2 ? 0.008 : 0.0, 0.0, i % 3 ? 0.004 : 0.0}, {0.1, 0.1});
  }
  EXPECT_EQ(reckoning.way(), 0.0);
  EXPECT_EQ(reckoning.turn(), 0.0);
}

}  // namespace
}  // namespace place_memory::core
