#include "sim/building/building_generator.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/robot/random_robot.h"
#include "sim/scene/world_loader.h"
#include "sim/senses/simulated_scan.h"

namespace place_memory::sim {
namespace {

class GeneratedBuilding : public testing::TestWithParam<int> {
 protected:
  BuildingKind kind() const { return static_cast<BuildingKind>(GetParam()); }
};

TEST_P(GeneratedBuilding, HasValidConnectedPlaces) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const World world = generateBuilding(kind(), seed);
    EXPECT_GE(world.places.size(), 4U) << world.name;
    EXPECT_LE(world.places.size(), 60U) << world.name;
    EXPECT_NO_THROW(validateWorld(world, 0.999 * placeClearance(kind())));
    for (const auto& neighbours : placeNeighbours(world)) EXPECT_FALSE(neighbours.empty());
  }
}

TEST_P(GeneratedBuilding, RepeatsBySeed) {
  const World a = generateBuilding(kind(), 17);
  const World b = generateBuilding(kind(), 17);
  ASSERT_EQ(a.places.size(), b.places.size());
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    EXPECT_EQ(a.places[i].position.x, b.places[i].position.x);
    EXPECT_EQ(a.places[i].links, b.places[i].links);
  }
  const Scene scene_a(a);
  const Scene scene_b(b);
  ASSERT_EQ(scene_a.segments().size(), scene_b.segments().size());
  for (std::size_t i = 0; i < scene_a.segments().size(); ++i) {
    EXPECT_EQ(scene_a.segments()[i].a.x, scene_b.segments()[i].a.x);
  }
}

TEST_P(GeneratedBuilding, ScansHearAPlausibleShareOfEchoes) {
  std::size_t echoes = 0;
  std::size_t readings = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const World world = generateBuilding(kind(), seed);
    const Scene scene(world);
    const SimulatedRobot robot =
        kind() == BuildingKind::kArena ? randomSpinningRobot(seed) : SimulatedRobot{};
    Rng rng(seed);
    const Vec2 at = world.places[0].position;
    for (const auto& reading : simulateScan(scene, {at.x, at.y, 0.0}, 0.0, robot, nullptr, rng)) {
      ++readings;
      echoes += std::isfinite(reading.range) ? 1 : 0;
    }
  }
  const double share = static_cast<double>(echoes) / static_cast<double>(readings);
  EXPECT_GT(share, 0.6);
  EXPECT_LT(share, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Kinds, GeneratedBuilding, testing::Range(0, kBuildingKinds));

TEST(BuildingGenerator, SeedsVaryTheKindAndTheSize) {
  std::set<std::string> kinds;
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const World world = generateBuilding(seed);
    kinds.insert(world.name.substr(0, world.name.rfind('_')));
    sizes.insert(world.places.size());
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kBuildingKinds));
  EXPECT_GT(sizes.size(), 10U);
}

}  // namespace
}  // namespace place_memory::sim
