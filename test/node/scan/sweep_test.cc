#include "node/scan/sweep.h"

#include <gtest/gtest.h>

#include "node/scan/scan_collector_fixture.h"

namespace place_memory::node {
namespace {

constexpr double kTick = 0.05;  // between two updates [s]

// A robot that obeys at once.
class SweepTest : public ScanCollectorTest {
 protected:
  Sweep sweepOf(config::Turn turn, int headings = 3) {
    ScanRequest request;
    request.headings = headings;
    request.step = kStep;
    request.turn = turn;
    request.timeout = 20.0;
    return Sweep(request, parameters_, collector());
  }

  // Lets the sweep go on until it is over, or for so many seconds. Returns how it ended.
  std::optional<ScanOutcome> run(Sweep& sweep, double seconds) {
    for (const double end = now_ + seconds; now_ < end; now_ += kTick) {
      robot_.yaw += rate_ * kTick;
      if (has_odometry_) odometry(now_, robot_);
      heading(now_, robot_.yaw);
      for (int k = 0; k < kSensors; ++k) range(now_, k, 1.0);
      process(now_);
      const Sweep::Step step = sweep.update(toNanoseconds(now_));
      phases_.insert(sweep.phase());
      if (step.rate) rate_ = *step.rate;
      if (step.outcome) return step.outcome;
    }
    return std::nullopt;
  }

  double now_ = kStart;
  core::Pose2d robot_;
  double rate_ = 0.0;
  bool has_odometry_ = true;
  std::set<ScanPhase> phases_;
};

TEST_F(SweepTest, WaitsForTime) {
  Sweep sweep = sweepOf(config::Turn::kListen);
  const Sweep::Step step = sweep.update(std::chrono::nanoseconds(0));
  EXPECT_FALSE(step.rate || step.outcome);
  EXPECT_EQ(sweep.phase(), ScanPhase::kWaitingForTime);
  EXPECT_EQ(sweep.started(), std::chrono::nanoseconds(0));
}

TEST_F(SweepTest, TurnsToTheFirstHeadingFromHeadingToHeadingAndBack) {
  Sweep sweep = sweepOf(config::Turn::kCmdVel);
  const auto outcome = run(sweep, 20.0);
  ASSERT_TRUE(outcome);
  ASSERT_TRUE(outcome->scan) << outcome->message;
  EXPECT_EQ(phases_,
            (std::set<ScanPhase>{ScanPhase::kToFirst, ScanPhase::kSweeping, ScanPhase::kBack}));
  EXPECT_NEAR(robot_.yaw, 0.0, 0.02);
}

TEST_F(SweepTest, ListensWhileSomethingElseTurnsTheRobot) {
  Sweep sweep = sweepOf(config::Turn::kListen);
  rate_ = 0.2;
  const auto outcome = run(sweep, 20.0);
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->scan) << outcome->message;
  EXPECT_EQ(phases_, (std::set<ScanPhase>{ScanPhase::kListening}));
  EXPECT_EQ(rate_, 0.2) << "it is not the node that turns it";
}

TEST_F(SweepTest, EndsWhereOdometryGoesStaleWhileTheRobotTurns) {
  Sweep sweep = sweepOf(config::Turn::kCmdVel, 11);
  ASSERT_FALSE(run(sweep, 1.0));
  has_odometry_ = false;
  const auto outcome = run(sweep, 2.0);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, ScanStatus::kNoOdometry);
}

TEST_F(SweepTest, WaitsForTheFirstOdometryAsLongAsItHolds) {
  has_odometry_ = false;
  Sweep sweep = sweepOf(config::Turn::kCmdVel);
  EXPECT_FALSE(run(sweep, parameters_.scan.heading_timeout - kTick));
  const auto outcome = run(sweep, 3 * kTick);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, ScanStatus::kNoOdometry);
  EXPECT_EQ(rate_, 0.0) << "the robot is not moved";
}

TEST_F(SweepTest, AStepOfMoreThan2147483648SecondsIsTheEndOfItsTime) {
  for (const config::Turn turn : {config::Turn::kListen, config::Turn::kCmdVel}) {
    Sweep sweep = sweepOf(turn);
    sweep.update(std::chrono::seconds(100));
    const Sweep::Step step = sweep.update(std::chrono::seconds(4294967295));
    ASSERT_TRUE(step.outcome);
    EXPECT_EQ(step.outcome->scan, nullptr);
    EXPECT_NE(step.outcome->message.find("not over after 20 s"), std::string::npos);
    collector().drop();
  }
}

TEST_F(SweepTest, ATimeoutSaysThatNothingTurnedTheRobot) {
  Sweep sweep = sweepOf(config::Turn::kListen);
  const auto outcome = run(sweep, 21.0);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, ScanStatus::kTimeout);
  EXPECT_NE(outcome->message.find("nothing turned the robot"), std::string::npos);
}

}  // namespace
}  // namespace place_memory::node
