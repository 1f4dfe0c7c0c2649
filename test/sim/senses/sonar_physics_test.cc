#include "sim/senses/sonar_physics.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim/senses/laser_model.h"

namespace place_memory::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const core::SonarSpec kSpec{0.436, 0.15, 4.572};
const Material kSmooth{0.2, 1.0, 0.95};
const Material kRough{1.5, 1.0, 0.3};

SonarPhysics noiseless() {
  SonarPhysics physics;
  physics.threshold_noise = 0.0;
  physics.relative_noise = 0.0;
  physics.absolute_noise = 0.0;
  physics.drop_probability = 0.0;
  physics.cross_talk = 0.0;
  return physics;
}

double ping(const World& world, const core::Pose2d& sensor,
            const SonarPhysics& physics = noiseless()) {
  Rng rng(1);
  return pingSonar(Scene(world), {}, sensor, kSpec, physics, rng);
}

World wallAt(double x, const Material& material) {
  World world;
  world.walls.push_back({{{x, -20.0}, {x, 20.0}}, material});
  return world;
}

TEST(SonarPhysics, AWallMetHeadOnIsItsDistance) {
  for (const double distance : {0.3, 1.0, 2.5, 4.4}) {
    EXPECT_NEAR(ping(wallAt(distance, kSmooth), {0.0, 0.0, 0.0}), distance, 1e-9);
  }
}

TEST(SonarPhysics, AConeTurnedAsideStillHearsTheNormal) {
  EXPECT_NEAR(ping(wallAt(2.0, kSmooth), {0.0, 0.0, 0.15}), 2.0, 0.002);
}

TEST(SonarPhysics, BeyondTheCriticalAngleASmoothWallIsNotHeard) {
  const double turned = 0.5 * kSpec.field_of_view + 0.2 + 0.05;
  EXPECT_EQ(ping(wallAt(2.0, kSmooth), {0.0, 0.0, turned}), kInfinity);
}

TEST(SonarPhysics, ARoughWallIsHeardWhereTheConeFirstMeetsIt) {
  const double turned = 0.5;
  const double nearest = 2.0 / std::cos(turned - 0.5 * kSpec.field_of_view);
  EXPECT_NEAR(ping(wallAt(2.0, kRough), {0.0, 0.0, turned}), nearest, 0.03);
}

// A mirror at 45 degrees sends the pulse to a wall off to the side: 2 m there and 1.5 m on.
TEST(SonarPhysics, AMirrorGivesTheLengthOfTheWholePath) {
  World world;
  world.walls.push_back({{{1.0, -1.0}, {3.0, 1.0}}, kSmooth});
  EXPECT_EQ(ping(world, {0.0, 0.0, 0.0}), kInfinity);
  world.walls.push_back({{{-2.0, 1.5}, {6.0, 1.5}}, kSmooth});
  EXPECT_NEAR(ping(world, {0.0, 0.0, 0.0}), 3.5, 0.01);
}

TEST(SonarPhysics, MirrorsAreFollowedNoFurtherThanAsked) {
  World world;
  world.walls.push_back({{{1.0, -1.0}, {3.0, 1.0}}, kSmooth});
  world.walls.push_back({{{-2.0, 1.5}, {6.0, 1.5}}, kSmooth});
  SonarPhysics direct_only = noiseless();
  direct_only.max_bounces = 0;
  EXPECT_EQ(ping(world, {0.0, 0.0, 0.0}, direct_only), kInfinity);
}

TEST(SonarPhysics, AConcaveCornerEchoesThoughBothWallsAreTooOblique) {
  World world;
  world.walls.push_back({{{-5.0, 2.0}, {2.0, 2.0}, {2.0, -5.0}}, kSmooth});
  EXPECT_NEAR(ping(world, {0.0, 0.0, core::kPi / 4.0}), std::sqrt(8.0), 1e-6);
}

TEST(SonarPhysics, AConvexEdgeIsHeardFromNearOnly) {
  World world;
  world.boxes.push_back({{0.0, 0.0, core::kPi / 4.0}, 1.0, 1.0, kSmooth});
  const double corner = std::sqrt(0.5);
  EXPECT_NEAR(ping(world, {-corner - 1.0, 0.0, 0.0}), 1.0, 1e-6);
  EXPECT_EQ(ping(world, {-corner - 4.0, 0.0, 0.0}), kInfinity);
}

TEST(SonarPhysics, AThinLegIsHeardFromNearOnly) {
  World world;
  world.posts.push_back({{0.0, 0.0}, 0.02, {0.3, 0.25, 0.85}});
  EXPECT_NEAR(ping(world, {-1.0, 0.0, 0.0}), 0.98, 1e-9);
  EXPECT_EQ(ping(world, {-4.3, 0.0, 0.0}), kInfinity);
}

TEST(SonarPhysics, LegsBetweenTheSubraysAreNotMissed) {
  World world;
  world.posts.push_back({{0.0, 0.0}, 0.02, {0.3, 0.9, 0.85}});
  for (double turn = -0.2; turn <= 0.2; turn += 0.01) {
    EXPECT_NEAR(ping(world, {-2.5, 0.0, turn}), 2.48, 1e-9) << turn;
  }
}

TEST(SonarPhysics, PeopleStandInTheWay) {
  Rng rng(1);
  const Scene scene(wallAt(3.0, kSmooth));
  const std::vector<Circle> person = {{{1.5, 0.0}, 0.2, 0.7}};
  EXPECT_NEAR(pingSonar(scene, person, {0.0, 0.0, 0.0}, kSpec, noiseless(), rng), 1.3, 1e-9);
}

TEST(SonarPhysics, BeyondItsLimitsTheRangeIsInfinite) {
  EXPECT_EQ(ping(wallAt(4.7, kSmooth), {0.0, 0.0, 0.0}), kInfinity);
  EXPECT_EQ(ping(wallAt(0.1, kSmooth), {0.0, 0.0, 0.0}), -kInfinity);
  EXPECT_EQ(ping(World{}, {0.0, 0.0, 0.0}), kInfinity);
}

TEST(SonarPhysics, ARougherSurfaceIsHeardMoreObliquely) {
  const double turned = 0.5 * kSpec.field_of_view + 0.25;
  SonarPhysics short_wave = noiseless();
  EXPECT_EQ(ping(wallAt(2.0, kSmooth), {0.0, 0.0, turned}, short_wave), kInfinity);
  short_wave.roughness = 4.0;
  EXPECT_LT(ping(wallAt(2.0, kSmooth), {0.0, 0.0, turned}, short_wave), 2.3);
}

TEST(SonarPhysics, NoiseAndLostEchoesAreAsAskedFor) {
  const Scene scene(wallAt(2.0, kSmooth));
  SonarPhysics physics = noiseless();
  physics.relative_noise = 0.02;
  physics.drop_probability = 0.1;
  Rng rng(7);
  constexpr int kPings = 5000;
  int lost = 0;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kPings; ++i) {
    const double range = pingSonar(scene, {}, {0.0, 0.0, 0.0}, kSpec, physics, rng);
    if (range == kInfinity) {
      ++lost;
      continue;
    }
    sum += range - 2.0;
    squares += (range - 2.0) * (range - 2.0);
  }
  EXPECT_NEAR(lost, 0.1 * kPings, 80);
  EXPECT_NEAR(sum / (kPings - lost), 0.0, 0.003);
  EXPECT_NEAR(std::sqrt(squares / (kPings - lost)), 0.04, 0.002);
}

TEST(LaserModel, MeasuresEveryWallAtAnyAngle) {
  World world;
  world.walls.push_back(
      {{{3.0, -2.0}, {3.0, 2.0}, {-3.0, 2.0}, {-3.0, -2.0}, {3.0, -2.0}}, kSmooth});
  LaserModel laser;
  laser.noise = 0.0;
  laser.drop_probability = 0.0;
  Rng rng(1);
  const auto readings = simulateLaserScan(Scene(world), {}, {0.0, 0.0, 0.0}, 0.3, laser, rng);
  ASSERT_EQ(readings.size(), 360U);
  for (const core::SonarReading& reading : readings) {
    const Vec2 direction = unitVector(reading.sensor_pose.yaw - 0.3);
    const double expected = std::fmin(3.0 / std::fabs(direction.x), 2.0 / std::fabs(direction.y));
    EXPECT_NEAR(reading.range, expected, 1e-6);
  }
}

}  // namespace
}  // namespace place_memory::sim
