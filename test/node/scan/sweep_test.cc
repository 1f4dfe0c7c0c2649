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

  // One that plans its turn.
  Sweep planned(config::Turn turn, double timeout = 20.0) {
    ScanRequest request;
    request.turn = turn;
    request.timeout = timeout;
    request.longer_if_needed = timeout == 0.0;
    return Sweep(request, parameters_, collector());
  }

  // Lets the sweep go on until it is over, or for so many seconds. Returns how it ended.
  std::optional<ScanOutcome> run(Sweep& sweep, double seconds) {
    for (const double end = now_ + seconds; now_ < end; now_ += kTick) {
      robot_.yaw += gain_ * rate_ * kTick;
      if (has_odometry_) odometry(now_, robot_);
      heading(now_, compass_gain_ * robot_.yaw);
      for (int k = 0; k < kSensors; ++k) range(now_, k, heard_);
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
  double gain_ = 1.0;          // of the base
  double compass_gain_ = 1.0;  // of the compass
  bool has_odometry_ = true;
  double heard_ = 1.0;  // by each sensor [m]
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

TEST_F(SweepTest, DoesNotGoOnTurningForReadingsThatCannotBeUsed) {
  heard_ = std::numeric_limits<double>::quiet_NaN();
  Sweep sweep = sweepOf(config::Turn::kCmdVel);
  const auto outcome = run(sweep, 15.0);
  ASSERT_TRUE(outcome) << "it would turn until its timeout";
  EXPECT_EQ(outcome->status, ScanStatus::kTooFewReadings);
  EXPECT_NE(outcome->message.find("NaN"), std::string::npos) << outcome->message;
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

TEST_F(SweepTest, ABaseThatDoesNotTurnIsToldFromATopicThatNobodyHears) {
  gain_ = 0.0;
  for (const bool listened : {true, false}) {
    Sweep sweep = sweepOf(config::Turn::kCmdVel);
    sweep.setListened(listened);
    const auto outcome = run(sweep, 20.0);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->status, ScanStatus::kBaseDisobeys);
    EXPECT_EQ(outcome->message.find("nothing listens to cmd_vel") == std::string::npos, listened)
        << outcome->message;
    collector().drop();
  }
}

TEST_F(SweepTest, PlansItsTurnByTheSensorsThereAre) {
  Sweep sweep = planned(config::Turn::kCmdVel, 0.0);
  const auto outcome = run(sweep, 200.0);
  ASSERT_TRUE(outcome);
  ASSERT_TRUE(outcome->scan) << outcome->message;
  EXPECT_NE(outcome->message.find("4 sensors leave a gap of 67.1 degrees"), std::string::npos)
      << outcome->message;
  EXPECT_GT(sweep.request().headings, 11);
  EXPECT_NEAR((sweep.request().headings - 1) * sweep.request().step, 1.37, 0.1);
  EXPECT_GT(sweep.request().timeout, 20.0) << "as long as the turn needs";
  EXPECT_NEAR(robot_.yaw, 0.0, 0.02);
}

TEST_F(SweepTest, SaysHowFarSomebodyIsToTurnTheRobot) {
  Sweep sweep = planned(config::Turn::kListen);
  const auto outcome = run(sweep, 21.0);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, ScanStatus::kTimeout);
  EXPECT_NE(outcome->message.find("4 sensors leave a gap"), std::string::npos) << outcome->message;
  EXPECT_NE(outcome->message.find("nothing turned the robot"), std::string::npos);
}

TEST_F(SweepTest, ABaseThatTurnsTheOtherWayIsStoppedWithAWord) {
  gain_ = -1.0;
  Sweep sweep = sweepOf(config::Turn::kCmdVel, 11);
  const auto outcome = run(sweep, 2.0);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, ScanStatus::kBaseDisobeys);
  EXPECT_NE(outcome->message.find("turns the other way"), std::string::npos) << outcome->message;
  EXPECT_NE(outcome->message.find("swap the sign of angular.z"), std::string::npos);
  EXPECT_LT(std::abs(robot_.yaw), 0.15);
}

TEST_F(SweepTest, OdometryOfTheWrongSignIsNamedByTheCompass) {
  gain_ = -1.0;
  compass_gain_ = -1.0;
  Sweep sweep = sweepOf(config::Turn::kCmdVel, 11);
  const auto outcome = run(sweep, 2.0);
  ASSERT_TRUE(outcome);
  EXPECT_NE(outcome->message.find("swap the sign of odometry's yaw"), std::string::npos)
      << outcome->message;
}

TEST_F(SweepTest, ABaseThatStandsIsToldFromOneThatIsSlow) {
  gain_ = 0.0;
  Sweep standing = sweepOf(config::Turn::kCmdVel, 11);
  auto outcome = run(standing, 19.0);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, ScanStatus::kBaseDisobeys);
  EXPECT_NE(outcome->message.find("does not turn"), std::string::npos) << outcome->message;
  EXPECT_NE(outcome->message.find("0.20 rad/s were sent on cmd_vel"), std::string::npos);

  collector().drop();
  gain_ = 0.05;
  Sweep slow = sweepOf(config::Turn::kCmdVel, 11);
  outcome = run(slow, 21.0);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, ScanStatus::kTimeout);
  EXPECT_NE(outcome->message.find("turned by 0."), std::string::npos) << outcome->message;
}

TEST_F(SweepTest, AScanWhoseCompassDoesNotFollowOdometryIsDoubtful) {
  for (const double gain : {0.0, -1.0}) {
    compass_gain_ = gain;
    collector().drop();
    Sweep sweep = sweepOf(config::Turn::kCmdVel, 11);
    const auto outcome = run(sweep, 20.0);
    ASSERT_TRUE(outcome);
    ASSERT_TRUE(outcome->scan) << outcome->message;
    const char* word = gain == 0.0 ? "stands still" : "turns the other way";
    EXPECT_NE(outcome->scan->doubt.find(word), std::string::npos) << outcome->scan->doubt;
    EXPECT_NE(outcome->message.find("not to be relied on"), std::string::npos);
    EXPECT_NE(collector().compassHealth().doubt.find(word), std::string::npos);
  }
}

TEST_F(SweepTest, ACompassIsDoubtedUntilATurnShowsThatItIsWell) {
  compass_gain_ = -1.0;
  Sweep doubtful = sweepOf(config::Turn::kCmdVel, 11);
  ASSERT_TRUE(run(doubtful, 20.0));
  rate_ = 0.0;
  for (const double end = now_ + 20.0; now_ < end; now_ += kTick) {
    odometry(now_, robot_);
    heading(now_, compass_gain_ * robot_.yaw);
    process(now_);
  }
  const std::string doubt = collector().compassHealth().doubt;
  EXPECT_NE(doubt.find("heading/reversed"), std::string::npos) << "at rest: " << doubt;
  collector().drop();
  compass_gain_ = 1.0;
  Sweep good = sweepOf(config::Turn::kCmdVel, 11);
  ASSERT_TRUE(run(good, 20.0));
  EXPECT_EQ(collector().compassHealth().doubt, "");
}

}  // namespace
}  // namespace place_memory::node
