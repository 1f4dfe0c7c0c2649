#include "trials/out_and_back.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mapping/mapping_figures.h"
#include "mapping/mapping_worlds.h"

namespace place_memory::mapping {
namespace {

const std::string kWorlds = std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds";

double length(const sim::World& world, const std::vector<std::size_t>& places) {
  double sum = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const sim::Vec2 a = world.places[places[i - 1]].position;
    const sim::Vec2 b = world.places[places[i]].position;
    sum += std::hypot(b.x - a.x, b.y - a.y);
  }
  return sum;
}

TEST(OutAndBack, TheLongestWayFollowsLinksFromEndToEnd) {
  const sim::World world = mappingWorld("hallway", 1, kWorlds);
  const auto links = sim::placeNeighbours(world);
  const std::vector<std::size_t> places = trials::longestWay(world);
  ASSERT_GE(places.size(), 2U);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const auto& next = links[places[i - 1]];
    EXPECT_EQ(std::count(next.begin(), next.end(), places[i]), 1);
  }
  EXPECT_GT(length(world, places), 30.0);
}

/// A hallway driven to its end and back by eight sonars on the front, without a compass, by wheels
/// that bend.
TEST(OutAndBack, SonarsThatLookAheadKnowTheWayBackAgain) {
  const sim::World world = mappingWorld("hallway", 1, kWorlds);
  sim::SimulatedRobot robot;
  for (const double bearing : {-90.0, -50.0, -30.0, -10.0, 10.0, 30.0, 50.0, 90.0}) {
    robot.ring.mounts.push_back(core::Pose2d{0.0, 0.0, bearing * core::kPi / 180.0} *
                                core::Pose2d{robot.ring.radius, 0.0, 0.0});
  }
  robot.ring.count = 8;
  trials::DriveRecipe recipe;
  recipe.compass_sigma = -1.0;
  const trials::Drive way =
      trials::driveOutAndBack(world, robot, recipe, trials::longestWay(world), 100);
  core::Mapper mapper(mapperOptions());
  Truth truth;
  const MappingFigures found = figures(mapper, drive(mapper, way, {}, truth), truth);
  EXPECT_GT(found.way, 60.0);
  EXPECT_LT(found.final, 0.5);
  EXPECT_EQ(found.doubled, 0U);
  EXPECT_EQ(found.false_ties, 0U);
  EXPECT_EQ(found.wrong, 0U);
  EXPECT_GT(2 * found.known, found.again);
}

}  // namespace
}  // namespace place_memory::mapping
