#include "core/sensing/sweep_turner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/sensing/simulated_turn.h"

namespace place_memory::core {
namespace {

constexpr double kStep = kPi / 90.0;
constexpr double kMaxRate = 0.2;

Turned sweep(const SimulatedTurn& base, int headings = 11, double step = kStep,
             double start = 0.0) {
  SweepTurner turner(headings, step, kMaxRate);
  return turn(turner, headings, step, base, start);
}

TEST(SweepTurner, SweepsEvenlyAboutWhereItBeganAndComesBack) {
  const Turned t = sweep({}, 11, kStep, 3.1);
  ASSERT_TRUE(t.done);
  EXPECT_NEAR(t.least, -5 * kStep, 0.02);
  EXPECT_NEAR(t.most, 5 * kStep, 0.02);
  EXPECT_NEAR(t.yaw, 0.0, 0.01);
  EXPECT_GE(t.headings, 11);
  EXPECT_LE(t.fastest, kMaxRate);
}

TEST(SweepTurner, GoesThroughAFullTurnAndEndsWhereItBegan) {
  const Turned t = sweep({}, 72, kPi / 36.0, -2.0);
  ASSERT_TRUE(t.done);
  EXPECT_GE(t.least, -0.02);
  EXPECT_NEAR(t.most, 2.0 * kPi, 0.1);
  EXPECT_NEAR(wrapAngle(t.yaw), 0.0, 0.01);
}

TEST(SweepTurner, StepsSmallerThanARobotCanTurnComeToAnEnd) {
  for (const double step : {0.001, 0.002, 0.003, 0.005}) {
    const Turned t = sweep({}, 5, step);
    EXPECT_TRUE(t.done) << step;
    EXPECT_NEAR(t.yaw, 0.0, 0.005) << step;
  }
}

TEST(SweepTurner, ASingleHeadingNeedsNoTurn) {
  const Turned t = sweep({}, 1);
  EXPECT_TRUE(t.done);
  EXPECT_EQ(t.fastest, 0.0);
}

TEST(SweepTurner, StaysAtAHeadingThatIsNotOver) {
  SweepTurner turner(11, kStep, kMaxRate);
  double yaw = 0.0;
  for (int i = 0; i < 2000; ++i) {
    yaw += 0.05 * turner.update(std::chrono::milliseconds(50) * i, yaw, 0, false);
  }
  EXPECT_TRUE(turner.started());
  EXPECT_FALSE(turner.swept());
  EXPECT_NEAR(yaw, -5 * kStep, 0.01);
}

TEST(SweepTurner, GoesOnWhereEverythingWasHeardAtTheHeadingBefore) {
  SweepTurner turner(2, kStep, kMaxRate);
  double yaw = 0.0;
  for (int i = 0; i < 400; ++i) {
    yaw += 0.05 * turner.update(std::chrono::milliseconds(50) * i, yaw, 0, true);
  }
  EXPECT_GT(yaw, 2 * kStep) << "it does not wait for what has been";
}

TEST(SweepTurner, AHeadingThatIsPassedCountsAsReached) {
  SweepTurner turner(3, kStep, kMaxRate);
  const auto at = [](double seconds) { return std::chrono::nanoseconds(int64_t(seconds * 1e9)); };
  turner.update(at(0.0), 0.0, 0, false);
  EXPECT_LT(turner.update(at(0.3), 0.0, 0, false), 0.0);
  EXPECT_EQ(turner.update(at(0.6), -2 * kStep, 0, false), 0.0) << "it does not swing back";
}

TEST(SweepTurner, WaitsForARobotThatStillTurnsFromBefore) {
  SweepTurner turner(11, kStep, kMaxRate);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(turner.update(std::chrono::milliseconds(50) * i, 0.01 * i, 0, false), 0.0);
  }
  EXPECT_FALSE(turner.base().fault());
}

// Bases as people have them.
struct Kind {
  std::string name;
  SimulatedTurn base;
  double accuracy;  // of the way back [rad]
};

TEST(SweepTurner, BasesAsTheyAreComeToTheEndOfTheSweepAndBack) {
  const std::vector<Kind> kinds = {
      {"dead band 0.08", {0.08}, 0.03},
      {"dead band 0.19", {0.19}, 0.05},
      {"delay 0.2 s", {0.0, 0.2}, 0.03},
      {"delay 0.5 s", {0.0, 0.5}, 0.05},
      {"gain 0.3", {0.0, 0.0, 0.3}, 0.02},
      {"gain 3", {0.0, 0.0, 3.0}, 0.05},
      {"gain 3, delay 0.2 s", {0.0, 0.2, 3.0}, 0.15},
      {"steps of 0.02", {0.0, 0.0, 1.0, 0.02}, 0.03},
      {"steps of 0.03", {0.0, 0.1, 1.0, 0.03}, 0.04},
      {"noise 0.003", {0.0, 0.0, 1.0, 0.0, 0.003}, 0.03},
      {"dead band 0.08, delay 0.5 s", {0.08, 0.5}, 0.1},
      {"dead band 0.05, steps of 0.03, noise", {0.05, 0.1, 0.7, 0.03, 0.002}, 0.05},
  };
  for (const Kind& kind : kinds) {
    for (const double start : {0.0, 0.013, 3.12}) {
      const Turned t = sweep(kind.base, 11, kStep, start);
      EXPECT_TRUE(t.done) << kind.name;
      EXPECT_GE(t.headings, 11) << kind.name;
      EXPECT_NEAR(t.yaw, 0.0, kind.accuracy) << kind.name;
      EXPECT_LT(std::max(t.most, -t.least), 0.8) << kind.name;
      EXPECT_LT(t.seconds, 60.0) << kind.name;
      RecordProperty(kind.name, std::to_string(t.seconds));
    }
  }
}

TEST(SweepTurner, ADeadBandThatIsKnownIsKept) {
  SweepTurner turner(11, kStep, kMaxRate, 0.1);
  const Turned t = turn(turner, 11, kStep, {0.1});
  EXPECT_TRUE(t.done);
  EXPECT_EQ(turner.base().leastRate(), 0.1) << "it had not to be found out";
}

TEST(SweepTurner, ABaseThatTurnsTheOtherWayIsStopped) {
  const std::vector<SimulatedTurn> bases = {{0.0, 0.0, -1.0},
                                            {0.0, 0.5, -1.0},
                                            {0.0, 0.1, -0.3},
                                            {0.0, 0.0, -1.0, 0.03},
                                            {0.0, 0.1, -1.0, 0.0, 0.003},
                                            {0.0, 0.2, -3.0}};
  for (const SimulatedTurn& base : bases) {
    for (const int headings : {11, 100}) {
      SweepTurner turner(headings, headings == 11 ? kStep : kPi / 50.0, kMaxRate);
      const Turned t = turn(turner, headings, headings == 11 ? kStep : kPi / 50.0, base);
      ASSERT_TRUE(turner.base().fault()) << base.gain << ' ' << base.delay;
      EXPECT_EQ(*turner.base().fault(), BaseWatch::Fault::kOtherWay);
      const double rate = kMaxRate * std::abs(base.gain);
      EXPECT_LT(std::max(t.most, -t.least), std::max(0.035, base.quantum) + 0.1 + rate * 0.5);
      EXPECT_LT(t.seconds, 0.3 + base.delay + 0.035 / rate + 0.5);
    }
  }
}

TEST(SweepTurner, ABaseThatTurnsTheOtherWayIsStoppedHalfASecondAfterThatShowed) {
  for (const double gain : {-3.0, -1.0, -0.3, -0.1}) {
    for (const double delay : {0.0, 0.2, 0.5, 1.0}) {
      for (const double quantum : {0.0, 0.01, 0.03}) {
        for (const double noise : {0.0, 0.001}) {
          // Where steps are coarse, noise is no noise any more, but whole steps.
          if (quantum > 0.0 && noise > 0.0) continue;
          for (const int headings : {11, 100}) {
            const double step = headings == 11 ? kStep : kPi / 50.0;
            SweepTurner turner(headings, step, kMaxRate);
            const Turned t =
                turn(turner, headings, step, {0.0, delay, gain, quantum, noise}, 0.004);
            const std::string what = std::to_string(gain) + ", delay " + std::to_string(delay) +
                                     ", steps of " + std::to_string(quantum) + ", noise " +
                                     std::to_string(noise);
            ASSERT_TRUE(turner.base().fault()) << what;
            EXPECT_EQ(*turner.base().fault(), BaseWatch::Fault::kOtherWay) << what;
            EXPECT_LT(t.seconds - t.shown, 0.5) << what;
          }
        }
      }
    }
  }
}

TEST(SweepTurner, OdometryThatDriftsAtRestIsNoTurnTheOtherWay) {
  for (const double dead_band : {0.0, 0.08, 0.15}) {
    for (const double drift : {-0.01, -0.004, 0.004, 0.01}) {
      for (const double noise : {0.0, 0.001, 0.003}) {
        SweepTurner turner(11, kStep, kMaxRate);
        const Turned t = turn(turner, 11, kStep, {dead_band, 0.1, 1.0, 0.0, noise, drift});
        EXPECT_FALSE(turner.base().fault()) << dead_band << ' ' << drift << ' ' << noise;
        EXPECT_TRUE(t.done) << dead_band << ' ' << drift << ' ' << noise;
      }
    }
  }
}

TEST(SweepTurner, ABaseThatDoesNotMoveIsToldFromOneThatIsSlow) {
  SweepTurner turner(11, kStep, kMaxRate);
  const Turned t = turn(turner, 11, kStep, {1.0});
  ASSERT_TRUE(turner.base().fault());
  EXPECT_EQ(*turner.base().fault(), BaseWatch::Fault::kStands);
  EXPECT_LT(t.seconds, 8.0);

  SweepTurner slow(11, kStep, kMaxRate);
  turn(slow, 11, kStep, {0.0, 0.0, 0.05}, 0.0, 20.0);
  EXPECT_FALSE(slow.base().fault());
  EXPECT_NEAR(slow.base().turnedWay() / slow.base().sentWay(), 0.05, 0.02);
}

}  // namespace
}  // namespace place_memory::core
