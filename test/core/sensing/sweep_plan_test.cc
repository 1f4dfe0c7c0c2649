#include "core/sensing/sweep_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;

std::vector<SensorMount> ring(int count, double cone, double spacing, double first = 0.0) {
  std::vector<SensorMount> sensors;
  for (int i = 0; i < count; ++i) {
    sensors.push_back({(first + i * spacing) * kDegree, cone * kDegree});
  }
  return sensors;
}

std::vector<SensorMount> fullRing(int count, double cone) {
  return ring(count, cone, 360.0 / count);
}

// Directions of 360 that no cone has looked into.
int unseen(const std::vector<SensorMount>& sensors, const SweepPlan& plan) {
  int count = 0;
  for (int direction = 0; direction < 360; ++direction) {
    bool seen = false;
    for (int k = 0; k < plan.headings && !seen; ++k) {
      for (const SensorMount& sensor : sensors) {
        const double off = wrapAngle(sensor.bearing + k * plan.step - direction * kDegree);
        seen = seen || std::abs(off) <= 0.5 * sensor.field_of_view + 1e-9;
      }
    }
    if (!seen) ++count;
  }
  return count;
}

TEST(PlanSweep, AFullRingTurnsAsInThePaper) {
  for (const int count : {16, 24}) {
    const SweepPlan plan = planSweep(fullRing(count, 25.0));
    EXPECT_EQ(plan.headings, 11);
    EXPECT_NEAR(plan.step, 2.0 * kDegree, 1e-9);
    EXPECT_NE(plan.reason.find("no gap"), std::string::npos) << plan.reason;
  }
}

TEST(PlanSweep, WiderGapsAreClosedByTurningFurther) {
  const SweepPlan four = planSweep(fullRing(4, 27.0));
  EXPECT_FALSE(four.isFullTurn());
  EXPECT_GE((four.headings - 1) * four.step, 63.0 * kDegree);
  EXPECT_LT((four.headings - 1) * four.step, 90.0 * kDegree);
  EXPECT_NE(four.reason.find("4 sensors leave a gap of 63 degrees"), std::string::npos)
      << four.reason;
  const SweepPlan eight = planSweep(fullRing(8, 25.0));
  EXPECT_LT((eight.headings - 1) * eight.step, (four.headings - 1) * four.step);
}

TEST(PlanSweep, WhatLooksForwardAloneNeedsAFullTurn) {
  const SweepPlan one = planSweep(ring(1, 25.0, 0.0));
  EXPECT_TRUE(one.isFullTurn());
  EXPECT_NEAR(one.headings * one.step, 2.0 * kPi, 1e-9);
  EXPECT_NE(one.reason.find("a single sensor"), std::string::npos) << one.reason;
  const SweepPlan three = planSweep(ring(3, 15.0, 45.0, -45.0));
  EXPECT_TRUE(three.isFullTurn());
  EXPECT_NE(three.reason.find("3 sensors leave a gap of 255 degrees"), std::string::npos)
      << three.reason;
  EXPECT_NE(three.reason.find("full turn"), std::string::npos);
  const SweepPlan nine = planSweep(ring(9, 25.0, 16.875, -67.5));
  EXPECT_TRUE(nine.isFullTurn());
  EXPECT_LT(nine.headings, three.headings);
}

TEST(PlanSweep, EveryDirectionIsLookedIntoWhateverTheSensors) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<SensorMount> sensors;
    const int counts[] = {1, 3, 4, 8, 9, 16, 24, 200};
    const int count = counts[trial % 8];
    for (int i = 0; i < count; ++i) {
      sensors.push_back({20.0 * (any(rng) - 0.5), (4.0 + 40.0 * any(rng)) * kDegree});
    }
    const SweepPlan plan = planSweep(sensors);
    EXPECT_EQ(unseen(sensors, plan), 0) << count << ": " << plan.reason;
    EXPECT_GE(plan.headings * count, 96) << plan.reason;
    EXPECT_LE(plan.headings, 181) << plan.reason;
    EXPECT_LE((plan.headings - 1) * plan.step, 2.0 * kPi) << plan.reason;
    EXPECT_LT(reckonedSeconds(plan, 0.2), 260.0) << plan.reason;
  }
}

TEST(PlanSweep, AStepThatIsAskedForIsKept) {
  const SweepPlan plan = planSweep(fullRing(4, 27.0), 5.0 * kDegree);
  EXPECT_EQ(plan.step, 5.0 * kDegree);
  EXPECT_GE((plan.headings - 1) * plan.step, 63.0 * kDegree);
  EXPECT_LE(planSweep(ring(1, 25.0, 0.0), 0.001).headings, 3600);
}

TEST(PlanSweep, WithoutASensorAsForAFullRing) {
  const SweepPlan plan = planSweep({});
  EXPECT_EQ(plan.headings, 11);
  EXPECT_NEAR(plan.step, 2.0 * kDegree, 1e-9);
}

}  // namespace
}  // namespace place_memory::core
