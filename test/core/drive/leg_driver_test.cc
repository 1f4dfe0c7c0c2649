#include "core/drive/leg_driver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/drive/echo_ring.h"
#include "sim/robot/simulation.h"

namespace place_memory::core {
namespace {

using State = LegDriver::State;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr double kStep = 0.1;  // [s]

/// A robot in a hall of 12 x 6 m, with a wall across it that has an opening of 1.2 m in its middle,
/// and a door in that.
class LegDriverTest : public testing::Test {
 protected:
  static sim::World hall() {
    sim::World world;
    world.walls.push_back({{{0, 0}, {12, 0}, {12, 6}, {0, 6}, {0, 0}}, {}});
    world.walls.push_back({{{6, 0}, {6, 2.4}}, {}});
    world.walls.push_back({{{6, 3.6}, {6, 6}}, {}});
    return world;
  }

  void begin(sim::World world, const Pose2d& start) {
    sim::SimulationOptions options;
    options.drift = {0.0, 0.0, 0.0};
    simulation_ = std::make_unique<sim::Simulation>(std::move(world), start, options);
    begun_ = start;
    echoes_ = EchoRing(milliseconds(500));
  }

  Pose2d pose() const { return simulation_->base().truth(); }

  /// Until the driver is over, `seconds` at the longest; `meanwhile` before each step.
  void drive(LegDriver& driver, double seconds, const std::function<void()>& meanwhile = nullptr) {
    const double end = time_ + seconds;
    while (!driver.isOver() && time_ < end) {
      if (meanwhile) meanwhile();
      const nanoseconds now(std::llround(1e9 * time_));
      const std::vector<double> ranges = simulation_->fire();
      for (std::size_t i = 0; hears_ && i < ranges.size(); ++i) {
        echoes_.hear(static_cast<SensorId>(i), now,
                     sim::sensorPose(simulation_->robot().ring, static_cast<int>(i)), ranges[i]);
      }
      const Velocity velocity = driver.update(now, pose(), echoes_);
      if (driver.isOver()) {
        EXPECT_EQ(velocity.forward, 0.0);
        EXPECT_EQ(velocity.turn, 0.0);
      }
      EXPECT_LE(std::abs(velocity.forward), LegDriverOptions().speed + 1e-9);
      EXPECT_LE(std::abs(velocity.turn), LegDriverOptions().turn_rate + 1e-9);
      simulation_->step(kStep, velocity.forward, velocity.turn);
      time_ += kStep;
    }
  }

  std::unique_ptr<sim::Simulation> simulation_;
  Pose2d begun_;
  EchoRing echoes_{milliseconds(500)};
  bool hears_ = true;
  double time_ = 0.0;
};

TEST_F(LegDriverTest, TurnsGoesAndArrives) {
  begin(hall(), {2.0, 1.5, kPi});
  LegDriver driver({}, {4.5, 4.0, 0.0});
  drive(driver, 60.0);
  EXPECT_EQ(driver.state(), State::kArrived);
  EXPECT_LT(std::hypot(pose().x - 4.5, pose().y - 4.0), 0.3);
  EXPECT_LT(time_, 30.0);
  EXPECT_EQ(driver.why(), "");
}

TEST_F(LegDriverTest, GoesThroughAnOpening) {
  begin(hall(), {3.0, 3.2, 0.0});
  LegDriver driver({}, {9.0, 2.9, 0.0});
  drive(driver, 90.0);
  EXPECT_EQ(driver.state(), State::kArrived) << driver.why();
}

TEST_F(LegDriverTest, BacksOffBeforeAWallAndSaysThatTheWayIsBlocked) {
  begin(hall(), {3.0, 1.0, 0.0});
  LegDriver driver({}, {9.0, 1.0, 0.0});
  drive(driver, 90.0);
  EXPECT_EQ(driver.state(), State::kBlocked);
  EXPECT_NE(driver.why().find("in the way"), std::string::npos) << driver.why();
  EXPECT_LT(pose().x, 5.5);  // it never touched the wall, and has backed off since
  EXPECT_GT(pose().x, 3.0);
}

TEST_F(LegDriverTest, WaitsForWhatGoesAwayAgain) {
  sim::World crossed = hall();
  crossed.boxes.push_back({{4.0, 1.0, 0.0}, 0.4, 0.4, {}});
  begin(crossed, {2.0, 1.0, 0.0});
  LegDriver driver({}, {5.0, 1.0, 0.0});
  bool yielded = false;
  drive(driver, 15.0, [&] {
    if (driver.state() != State::kYielding || yielded) return;
    yielded = true;
    const Pose2d stands = pose();
    begin(hall(), stands);
  });
  EXPECT_TRUE(yielded);
  drive(driver, 60.0);
  EXPECT_EQ(driver.state(), State::kArrived) << driver.why();
}

TEST_F(LegDriverTest, WhatStandsBehindTheTargetIsNotInTheWay) {
  begin(hall(), {3.0, 1.0, 0.0});
  LegDriver driver({}, {5.2, 1.0, 0.0});
  drive(driver, 60.0);
  EXPECT_EQ(driver.state(), State::kArrived) << driver.why();
}

TEST_F(LegDriverTest, StopsWhereNoSonarIsHeard) {
  begin(hall(), {3.0, 1.0, 0.0});
  hears_ = false;
  LegDriver driver({}, {5.0, 1.0, 0.0});
  drive(driver, 10.0);
  EXPECT_EQ(driver.state(), State::kBlind);
  EXPECT_EQ(pose(), begun_);
}

// The post beside its way is too thin to be heard where it is.
TEST_F(LegDriverTest, GetsPastWhatItTouchesWithItsSide) {
  sim::World posted = hall();
  posted.posts.push_back({{3.0, 1.24}, 0.02, {}});
  begin(posted, {2.0, 1.0, 0.0});
  hears_ = false;
  LegDriver driver({}, {5.0, 1.0, 0.0});
  drive(driver, 60.0, [this] {
    const nanoseconds now(std::llround(1e9 * time_));
    echoes_.hear(0, now, {0.2, 0.0, 0.0}, 2.0);
  });
  EXPECT_EQ(driver.state(), State::kArrived) << driver.why();
}

TEST_F(LegDriverTest, GetsRoundWhatItDoesNotHearOnEitherSide) {
  for (const double y : {1.23, 0.77}) {
    sim::World posted = hall();
    posted.posts.push_back({{3.0, y}, 0.02, {}});
    begin(posted, {2.0, 1.0, 0.0});
    hears_ = false;
    LegDriver driver({}, {5.0, 1.0, 0.0});
    drive(driver, 90.0, [this] {
      const nanoseconds now(std::llround(1e9 * time_));
      echoes_.hear(0, now, {0.2, 0.0, 0.0}, 2.0);
    });
    EXPECT_EQ(driver.state(), State::kArrived) << y << ": " << driver.why();
  }
}

// A base that does not move, as one whose wheels slip.
TEST_F(LegDriverTest, SaysThatItDoesNotGetNearer) {
  begin(hall(), {3.0, 1.0, 0.0});
  LegDriver driver({}, {5.0, 1.0, 0.0});
  drive(driver, 60.0, [this] { simulation_->placeRobot(begun_); });
  EXPECT_EQ(driver.state(), State::kBlocked);
  EXPECT_NE(driver.why().find("nearer"), std::string::npos);
}

TEST(EchoRing, HearsEachConeOfALaser) {
  EchoRing ring(milliseconds(500));
  for (int degrees = -90; degrees <= 90; degrees += 5) {
    ring.hear(1, milliseconds(100), {0.0, 0.0, degrees * kPi / 180.0}, degrees == 0 ? 1.0 : 3.0);
  }
  EXPECT_NEAR(ring.ahead(milliseconds(200), 0.2), 1.0, 1e-9);
}

TEST(EchoRing, ForgetsWhatWasHeardLongAgo) {
  EchoRing ring(milliseconds(500));
  EXPECT_TRUE(ring.isBlind(milliseconds(0)));
  ring.hear(0, milliseconds(0), {0.2, 0.0, 0.0}, 1.0);
  EXPECT_FALSE(ring.isBlind(milliseconds(400)));
  EXPECT_NEAR(ring.ahead(milliseconds(400), 0.3), 1.2, 1e-9);
  EXPECT_TRUE(std::isinf(ring.behind(milliseconds(400), 0.3)));
  EXPECT_TRUE(ring.isBlind(milliseconds(600)));
  EXPECT_TRUE(std::isinf(ring.ahead(milliseconds(600), 0.3)));
  ring.hear(1, milliseconds(600), {-0.2, 0.0, kPi}, 1.0);
  EXPECT_TRUE(ring.isBlind(milliseconds(600)));  // it looks back
  EXPECT_NEAR(ring.behind(milliseconds(600), 0.3), 1.2, 1e-9);
}

}  // namespace
}  // namespace place_memory::core
