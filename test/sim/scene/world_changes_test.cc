#include "sim/scene/world_changes.h"

#include <gtest/gtest.h>

#include "sim/scene/world_loader.h"
#include "sim/senses/simulated_scan.h"

namespace place_memory::sim {
namespace {

World shipped(const std::string& name) {
  return loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/" + name + ".yaml");
}

// Readings that differ between two states of a world scanned with the same noise.
int differences(const World& before, const World& after, Vec2 at) {
  Rng first(9);
  Rng second(9);
  const core::Pose2d base{at.x, at.y, 0.0};
  const auto a = simulateScan(Scene(before), base, 0.0, SimulatedRobot{}, nullptr, first);
  const auto b = simulateScan(Scene(after), base, 0.0, SimulatedRobot{}, nullptr, second);
  int different = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const bool both = std::isfinite(a[i].range) && std::isfinite(b[i].range);
    const bool same = both ? std::fabs(a[i].range - b[i].range) < 0.1 : a[i].range == b[i].range;
    different += same ? 0 : 1;
  }
  return different;
}

TEST(WorldChanges, ChairsAreAddedSixFeetAwayAndSpread) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    World world = shipped("rooms");
    const std::size_t before = world.chairs.size();
    const Vec2 around = world.places[seed % 5].position;
    const int added = addChairs(world, around, 3, rng);
    ASSERT_EQ(world.chairs.size(), before + static_cast<std::size_t>(added));
    EXPECT_GE(added, 2);
    for (std::size_t i = before; i < world.chairs.size(); ++i) {
      const Vec2 chair{world.chairs[i].pose.x, world.chairs[i].pose.y};
      EXPECT_NEAR(norm(chair - around), 1.83, 0.81);
      for (std::size_t j = before; j < i; ++j) {
        const Vec2 other{world.chairs[j].pose.x, world.chairs[j].pose.y};
        EXPECT_GT(norm(chair - other), 0.6);
      }
    }
    EXPECT_NO_THROW(validateWorld(world, kPlaceClearance));
  }
}

TEST(WorldChanges, AnAddedChairShowsInTheReadings) {
  Rng rng(4);
  const World before = shipped("rooms");
  World after = before;
  ASSERT_EQ(addChairs(after, before.places[2].position, 1, rng), 1);
  EXPECT_GT(differences(before, after, before.places[2].position), 3);
}

TEST(WorldChanges, ADoorShowsInTheReadings) {
  const World before = shipped("hallway");
  World after = before;
  ASSERT_TRUE(setDoor(after, before.doors[1].name, !before.doors[1].open));
  const Vec2 middle = (before.doors[1].hinge + before.doors[1].latch) * 0.5;
  EXPECT_GT(differences(before, after, {middle.x, 0.0}), 3);
}

TEST(WorldChanges, AWhiteboardThatGoesShowsInTheReadings) {
  const World before = shipped("office");
  World after = before;
  ASSERT_TRUE(removeWhiteboard(after, before.whiteboards[0].name));
  EXPECT_TRUE(after.whiteboards.empty());
  const Vec2 beside = before.whiteboards[0].from + Vec2{1.0, -0.6};
  EXPECT_GT(differences(before, after, beside), 0);
}

TEST(WorldChanges, DoorsFlipByTheirShare) {
  Rng rng(2);
  World world = shipped("hallway");
  const World before = world;
  EXPECT_EQ(flipDoors(world, 0.0, rng), 0);
  const int flipped = flipDoors(world, 0.5, rng);
  int different = 0;
  for (std::size_t i = 0; i < world.doors.size(); ++i) {
    different += world.doors[i].open != before.doors[i].open ? 1 : 0;
  }
  EXPECT_EQ(different, flipped);
  EXPECT_NEAR(flipped, 0.5 * static_cast<double>(world.doors.size()), 1.0);
}

TEST(WorldChanges, RearrangingLeavesRoomAtEveryPlace) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Rng rng(seed);
    World world = shipped("office");
    EXPECT_GT(moveChairs(world, 0.8, 2.0, rng), 10);
    EXPECT_GT(moveFurniture(world, 0.5, 1.0, rng), 10);
    EXPECT_GE(addBicycles(world, 3, rng), 2);
    flipDoors(world, 1.0, rng);
    EXPECT_NO_THROW(validateWorld(world, kPlaceClearance)) << "seed " << seed;
  }
}

TEST(WorldChanges, FurnitureMovesByItsShareAndNoFurtherThanAsked) {
  Rng rng(3);
  const World before = shipped("office");
  World world = before;
  EXPECT_EQ(moveFurniture(world, 0.0, 1.0, rng), 0);
  const int moved = moveFurniture(world, 0.3, 1.0, rng);
  int different = 0;
  const auto compare = [&](const core::Pose2d& a, const core::Pose2d& b) {
    EXPECT_LE(std::hypot(a.x - b.x, a.y - b.y), 1.0);
    different += a.x != b.x ? 1 : 0;
  };
  for (std::size_t i = 0; i < world.boxes.size(); ++i) {
    compare(world.boxes[i].pose, before.boxes[i].pose);
  }
  for (std::size_t i = 0; i < world.tables.size(); ++i) {
    compare(world.tables[i].pose, before.tables[i].pose);
  }
  EXPECT_EQ(different, moved);
  EXPECT_GT(moved, 10);
}

TEST(WorldChanges, NamesThatAreNotThereAreRefused) {
  World world = shipped("rooms");
  EXPECT_FALSE(setDoor(world, "no such door", true));
  EXPECT_FALSE(moveChair(world, "no such chair", {}));
  EXPECT_FALSE(removeWhiteboard(world, "no such board"));
  EXPECT_TRUE(moveChair(world, world.chairs[0].name, {1.0, 1.5, 0.2}));
  EXPECT_EQ(world.chairs[0].pose.y, 1.5);
}

}  // namespace
}  // namespace place_memory::sim
