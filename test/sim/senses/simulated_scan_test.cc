#include "sim/senses/simulated_scan.h"

#include <gtest/gtest.h>

#include "sim/robot/random_robot.h"
#include "sim/scene/world_loader.h"

namespace place_memory::sim {
namespace {

std::string worldFile(const std::string& name) {
  return std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/" + name + ".yaml";
}

std::vector<core::SonarReading> scanOffice(std::uint64_t seed, int people, double heading_error) {
  static const World kOffice = loadWorld(worldFile("office"));
  static const Scene kScene(kOffice);
  Rng rng(seed);
  const Vec2 at = findPlace(kOffice, "26")->position;
  Crowd crowd = Crowd::passing(kOffice, at, people, rng);
  return simulateScan(kScene, {at.x, at.y, 0.5}, heading_error, SimulatedRobot{}, &crowd, rng);
}

bool same(const std::vector<core::SonarReading>& a, const std::vector<core::SonarReading>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].range != b[i].range || a[i].sensor_pose.yaw != b[i].sensor_pose.yaw) return false;
  }
  return true;
}

TEST(SimulatedScan, TakesElevenSetsOfSixteen) { EXPECT_EQ(scanOffice(1, 0, 0.0).size(), 176U); }

TEST(SimulatedScan, RepeatsBySeed) {
  EXPECT_TRUE(same(scanOffice(3, 2, 0.0), scanOffice(3, 2, 0.0)));
  EXPECT_FALSE(same(scanOffice(3, 2, 0.0), scanOffice(4, 2, 0.0)));
}

TEST(SimulatedScan, AHeadingErrorTurnsEverySensorAboutTheBase) {
  const auto straight = scanOffice(5, 0, 0.0);
  const auto turned = scanOffice(5, 0, 0.7);
  ASSERT_EQ(straight.size(), turned.size());
  for (std::size_t i = 0; i < straight.size(); ++i) {
    const core::Pose2d expected = core::Pose2d{0.0, 0.0, 0.7} * straight[i].sensor_pose;
    EXPECT_EQ(straight[i].range, turned[i].range);
    EXPECT_NEAR(turned[i].sensor_pose.x, expected.x, 1e-12);
    EXPECT_NEAR(turned[i].sensor_pose.y, expected.y, 1e-12);
    EXPECT_NEAR(core::wrapAngle(turned[i].sensor_pose.yaw - expected.yaw), 0.0, 1e-12);
  }
}

// What the scan frame says about a wall must be where the wall is, whatever the base's own heading.
TEST(SimulatedScan, EchoesLieOnTheWallInTheScanFrame) {
  World world;
  world.walls.push_back({{{2.0, -9.0}, {2.0, 9.0}}, {0.2, 1.0, 0.9}});
  SimulatedRobot robot;
  robot.physics.relative_noise = 0.0;
  robot.physics.absolute_noise = 0.0;
  robot.physics.drop_probability = 0.0;
  Rng rng(1);
  const auto readings = simulateScan(Scene(world), {0.5, 3.0, 1.1}, 0.0, robot, nullptr, rng);
  int near_normal = 0;
  for (const core::SonarReading& reading : readings) {
    if (std::fabs(reading.sensor_pose.yaw) > 0.02) continue;
    EXPECT_NEAR(reading.sensor_pose.x + reading.range, 1.5, 0.01);
    ++near_normal;
  }
  EXPECT_GT(near_normal, 0);
}

TEST(SimulatedScan, PeopleAreSeenInSomeOfTheReadingsOnly) {
  const auto alone = scanOffice(8, 0, 0.0);
  int disturbed_scans = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto crowded = scanOffice(seed, 3, 0.0);
    int nearer = 0;
    for (std::size_t i = 0; i < std::min(alone.size(), crowded.size()); ++i) {
      if (crowded[i].range < alone[i].range - 0.3) ++nearer;
    }
    disturbed_scans += nearer > 8 ? 1 : 0;
    EXPECT_LT(nearer, 100) << "seed " << seed;
  }
  EXPECT_GT(disturbed_scans, 3);
}

TEST(Crowd, NobodyWalksOverTheRobot) {
  const World hallway = loadWorld(worldFile("hallway"));
  Rng rng(2);
  const Vec2 robot = findPlace(hallway, "9")->position;
  Crowd crowd = Crowd::spread(hallway, 20, rng);
  for (int i = 0; i < 500; ++i) {
    crowd.step(0.3, robot, rng);
    for (const Circle& person : crowd.circles()) {
      ASSERT_GT(norm(person.center - robot), person.radius + 0.5);
    }
  }
}

TEST(Crowd, AWorldWithoutLinksHasNoPeople) {
  World world;
  world.places.push_back({"0", {0.0, 0.0}, {}});
  Rng rng(2);
  EXPECT_TRUE(Crowd::spread(world, 5, rng).circles().empty());
  EXPECT_TRUE(Crowd::passing(world, {3.0, 0.0}, 5, rng).circles().empty());
}

TEST(CrossTalk, TheNeighboursEarlierEchoIsHeard) {
  World world;
  world.posts.push_back({{1.5, 0.0}, 0.2, {0.3, 1.0, 0.9}});
  SimulatedRobot robot;
  robot.physics.cross_talk = 1.0;
  robot.physics.drop_probability = 0.0;
  Rng rng(1);
  const std::vector<double> ranges = fireRing(Scene(world), {}, {0.0, 0.0, 0.0}, robot, rng);
  EXPECT_NEAR(ranges[0], 1.08, 0.1);
  EXPECT_EQ(ranges[15], ranges[0]);
  EXPECT_GT(ranges[8], robot.ring.spec.max_range);
}

TEST(RandomRobot, StaysWithinItsDescription) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const SimulatedRobot robot = seed % 2 == 0 ? randomRobot(seed) : randomSpinningRobot(seed);
    const core::SonarSpec& spec = robot.ring.spec;
    EXPECT_GE(robot.ring.count, 1);
    EXPECT_LE(robot.ring.count, 24);
    EXPECT_GE(spec.field_of_view, 0.26);
    EXPECT_LE(spec.field_of_view, 0.70);
    EXPECT_LT(spec.min_range, spec.max_range);
    EXPECT_LE(spec.max_range, 6.0);
    EXPECT_LE(robot.physics.drop_probability, 0.1);
    EXPECT_GE(robot.sweep.headings * robot.ring.count, 24);
    EXPECT_EQ(randomRobot(seed).ring.count, randomRobot(seed).ring.count);
  }
}

}  // namespace
}  // namespace place_memory::sim
