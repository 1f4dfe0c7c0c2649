#include "sim/robot/simulation.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim/scene/world_loader.h"

namespace place_memory::sim {
namespace {

World rooms() {
  return loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/rooms.yaml");
}

core::Pose2d startIn(const World& world) {
  return {world.places[0].position.x, world.places[0].position.y, 0.0};
}

TEST(Simulation, DrivesWhereItIsToldAndOdometryFollows) {
  SimulationOptions options;
  options.drift = {0.0, 0.0, 0.0};
  Simulation simulation(rooms(), startIn(rooms()), options);
  const core::Pose2d start = simulation.base().truth();
  for (int i = 0; i < 10; ++i) simulation.step(0.1, 0.4, 0.3);
  const core::Pose2d moved = start.inverse() * simulation.base().truth();
  EXPECT_NEAR(moved.yaw, 0.3, 1e-9);
  EXPECT_NEAR(std::hypot(moved.x, moved.y), 0.4, 0.01);
  EXPECT_NEAR(simulation.base().odometry().x, moved.x, 1e-9);
  EXPECT_NEAR(simulation.base().odometry().y, moved.y, 1e-9);
  EXPECT_NEAR(simulation.base().odometry().yaw, moved.yaw, 1e-9);
}

TEST(Simulation, OdometryDrifts) {
  SimulationOptions options;
  options.drift = {0.05, 0.05, 0.05};
  Simulation simulation(rooms(), startIn(rooms()), options);
  const core::Pose2d start = simulation.base().truth();
  for (int i = 0; i < 100; ++i) simulation.step(0.1, 0.1, 0.6);
  const core::Pose2d moved = start.inverse() * simulation.base().truth();
  const core::Pose2d error = simulation.base().odometry().inverse() * moved;
  EXPECT_GT(std::fabs(error.yaw) + std::hypot(error.x, error.y), 0.01);
}

TEST(Simulation, StopsAtWalls) {
  Simulation simulation(rooms(), startIn(rooms()), {});
  for (int i = 0; i < 400; ++i) simulation.step(0.1, -0.5, 0.0);
  const core::Pose2d& at = simulation.base().truth();
  EXPECT_TRUE(simulation.scene().isFree({at.x, at.y}, 0.25));
  EXPECT_LT(std::hypot(at.x - rooms().places[0].position.x, at.y - rooms().places[0].position.y),
            3.5);
}

TEST(Simulation, TheCompassErrsTheSameAtTheSamePlace) {
  SimulationOptions options;
  options.compass_sigma = 0.2;
  Simulation simulation(rooms(), startIn(rooms()), options);
  const double before = simulation.compassHeading();
  ASSERT_TRUE(simulation.placeRobot({8.1, -0.4, 0.0}));
  const double elsewhere = simulation.compassHeading();
  ASSERT_TRUE(simulation.placeRobot(startIn(rooms())));
  EXPECT_EQ(simulation.compassHeading(), before);
  EXPECT_NE(elsewhere, before);
}

TEST(CompassField, HasTheSpreadAskedFor) {
  double squares = 0.0;
  constexpr int kSamples = 4000;
  const CompassField field(0.17, 5);
  Rng rng(1);
  for (int i = 0; i < kSamples; ++i) {
    const double error = field.errorAt({uniform(rng, 0.0, 200.0), uniform(rng, 0.0, 200.0)});
    squares += error * error;
  }
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.17, 0.02);
}

TEST(Simulation, RefusesWhatCannotBe) {
  Simulation simulation(rooms(), startIn(rooms()), {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(simulation.placeRobot({0.0, 0.0, 0.0}));
  EXPECT_FALSE(simulation.placeRobot({nan, 0.0, 0.0}));
  const std::string chair = rooms().chairs[0].name;
  EXPECT_EQ(simulation.setDoor("none", true), ChangeResult::kUnknownName);
  EXPECT_EQ(simulation.moveChair("none", {}), ChangeResult::kUnknownName);
  EXPECT_EQ(simulation.removeWhiteboard("none"), ChangeResult::kUnknownName);
  EXPECT_EQ(simulation.moveChair(chair, {nan, 0.0, 0.0}), ChangeResult::kBlocked);
  EXPECT_EQ(simulation.moveChair(chair, {1e12, 0.0, 0.0}), ChangeResult::kBlocked);
  EXPECT_EQ(simulation.moveChair(chair, simulation.base().truth()), ChangeResult::kBlocked);
  EXPECT_EQ(simulation.world().chairs[0].pose.x, rooms().chairs[0].pose.x);
}

TEST(Simulation, RearrangingLeavesTheRobotItsRoom) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SimulationOptions options;
    options.seed = seed;
    Simulation simulation(rooms(), {12.6, 1.0, 0.0}, options);
    EXPECT_GT(simulation.rearrange(1.0, 1.0, 2), 2);
    EXPECT_TRUE(simulation.scene().isFree({12.6, 1.0}, options.base_radius));
    EXPECT_EQ(simulation.world().places.size(), 5U);
  }
}

TEST(Simulation, RepeatsBySeed) {
  SimulationOptions options;
  options.people = 4;
  const auto run = [&] {
    Simulation simulation(rooms(), startIn(rooms()), options);
    simulation.rearrange(0.5, 0.5, 1);
    for (int i = 0; i < 20; ++i) simulation.step(0.2, 0.1, 0.2);
    return simulation.fire();
  };
  EXPECT_EQ(run(), run());
}

TEST(Simulation, AClosedDoorStopsTheRobotAndAnOpenOneDoesNot) {
  Simulation simulation(rooms(), startIn(rooms()), {});
  ASSERT_EQ(simulation.setDoor("door_23", false), ChangeResult::kDone);
  ASSERT_TRUE(simulation.placeRobot({16.4, 0.33, 0.0}));
  for (int i = 0; i < 60; ++i) simulation.step(0.1, 0.5, 0.0);
  EXPECT_LT(simulation.base().truth().x, 17.4);
  ASSERT_EQ(simulation.setDoor("door_23", true), ChangeResult::kDone);
  for (int i = 0; i < 60; ++i) simulation.step(0.1, 0.5, 0.0);
  EXPECT_GT(simulation.base().truth().x, 17.4);
}

}  // namespace
}  // namespace place_memory::sim
