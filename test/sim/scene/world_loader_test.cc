#include "sim/scene/world_loader.h"

#include <gtest/gtest.h>

#include "sim/scene/scene.h"

namespace place_memory::sim {
namespace {

std::string errorOf(const std::string& yaml) {
  try {
    parseWorld(yaml, "w.yaml");
  } catch (const WorldError& error) {
    return error.what();
  }
  return "no error";
}

struct Malformed {
  const char* yaml;
  const char* error;
};

class MalformedWorld : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedWorld, NamesFileLineAndFault) {
  EXPECT_EQ(errorOf(GetParam().yaml), GetParam().error);
}

const Malformed kMalformed[] = {
    {"", "w.yaml:1: the world must be a map of keys and values"},
    {"[1, 2]", "w.yaml:1: the world must be a map of keys and values"},
    {"walls: []", "w.yaml:1: the world lacks 'name'"},
    {"name: w\nrooms: []", "w.yaml:2: the world has an unknown key 'rooms'"},
    {"name: w\nwalls: 3", "w.yaml:2: the world: 'walls' must be a list"},
    {"name: w\nwalls: [3]", "w.yaml:2: a wall must be a map of keys and values"},
    {"name: w\nwalls:\n  - {material: wood}", "w.yaml:3: a wall lacks 'points'"},
    {"name: w\nwalls:\n  - {points: [[0, 0]]}",
     "w.yaml:3: a wall: 'points' must list at least two points"},
    {"name: w\nwalls:\n  - {points: [[0, 0], [1]]}",
     "w.yaml:3: a wall: 'points' must be a point [x, y]"},
    {"name: w\nwalls:\n  - {points: [[0, 0], [1, east]]}",
     "w.yaml:3: a wall: 'points' y must be a finite number"},
    {"name: w\nwalls:\n  - {points: [[0, 0], [.nan, 1]]}",
     "w.yaml:3: a wall: 'points' x must be a finite number"},
    {"name: w\nwalls:\n  - {points: [[0, 0], [.inf, 1]]}",
     "w.yaml:3: a wall: 'points' x must be a finite number"},
    {"name: w\nwalls:\n  - {points: [[0, 0], [1e9, 1]]}",
     "w.yaml:3: a wall: 'points' x is 1000000000, must be in [-1000, 1000]"},
    {"name: w\nwalls:\n  - {points: [[1, 1], [1, 1]]}",
     "w.yaml:3: a wall: 'points' repeats a point"},
    {"name: w\nwalls:\n  - {points: [[0, 0], [1, 1]], material: ice}",
     "w.yaml:3: material 'ice' is not defined"},
    {"name: w\nmaterials: [ice]", "w.yaml:2: the world: 'materials' must be a map"},
    {"name: w\nmaterials:\n  ice: {critical_angle: 2, strength: 1, mirror: 1}",
     "w.yaml:3: a material: 'critical_angle' is 2, must be in [0.01, 1.5708]"},
    {"name: w\nmaterials:\n  ice: {critical_angle: 1, strength: 0, mirror: 1}",
     "w.yaml:3: a material: 'strength' is 0, must be in [0.01, 1]"},
    {"name: w\nmaterials:\n  ice: {critical_angle: 1, strength: 1}",
     "w.yaml:3: a material lacks 'mirror'"},
    {"name: w\nposts:\n  - {at: [0, 0]}", "w.yaml:3: a post lacks 'radius'"},
    {"name: w\nposts:\n  - {at: [0, 0], radius: -1}",
     "w.yaml:3: a post: 'radius' is -1, must be in [0.005, 5]"},
    {"name: w\nboxes:\n  - {at: [0, 0], size: [1, 0]}",
     "w.yaml:3: 'size' must be at least 0.01 m each way"},
    {"name: w\ntables:\n  - {at: [0, 0], size: [1, 1], yaw: 90}",
     "w.yaml:3: a table: 'yaw' is 90, must be in [-6.283185, 6.283185]"},
    {"name: w\ndoors:\n  - {name: d, hinge: [0, 0], latch: [0, 0]}",
     "w.yaml:3: a door must be at least 0.1 m wide"},
    {"name: w\ndoors:\n  - {name: d, hinge: [0, 0], latch: [1, 0], open: ajar}",
     "w.yaml:3: a door: 'open' must be true or false"},
    {"name: w\nchairs:\n  - {at: [0, 0]}", "w.yaml:3: a chair lacks 'name'"},
    {"name: w\nchairs:\n  - {name: c, at: [0, 0]}\n  - {name: c, at: [1, 0]}",
     "w.yaml:4: the name 'c' is used twice"},
    {"name: w\nplaces:\n  - {label: [a], at: [0, 0]}", "w.yaml:3: a place: 'label' must be a word"},
    {"name: w\nplaces:\n  - {label: a, at: [0, 0]}\n  - {label: a, at: [1, 0]}",
     "w.yaml:4: place 'a' is defined twice"},
    {"name: w\nplaces:\n  - {label: a, at: [0, 0], links: [b]}",
     "w.yaml:3: place 'a' links to 'b', which is no other place"},
    {"name: w\nplaces:\n  - {label: a, at: [0, 0], links: [a]}",
     "w.yaml:3: place 'a' links to 'a', which is no other place"},
    {"name: w\nplaces:\n  - {label: a, at: [0, 0], links: b}",
     "w.yaml:3: a place: 'links' must be a list"},
    {"name: w\nposts:\n  - {at: [0, 0], radius: 0.5}\nplaces:\n  - {label: a, at: [0.6, 0]}",
     "w.yaml:5: place 'a' leaves no room for a robot"},
};

INSTANTIATE_TEST_SUITE_P(Cases, MalformedWorld, testing::ValuesIn(kMalformed));

TEST(WorldLoader, ASyntaxErrorNamesItsLine) {
  EXPECT_EQ(errorOf("name: w\nwalls: [").rfind("w.yaml:", 0), 0U);
}

TEST(WorldLoader, AMissingFileIsNamed) {
  try {
    loadWorld("/nowhere/world.yaml");
    FAIL() << "loaded a file that is not there";
  } catch (const WorldError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/world.yaml:1: the file cannot be read");
  }
}

TEST(WorldLoader, ReadsEveryKindOfThing) {
  const World world = parseWorld(
      "name: w\n"
      "materials: {ice: {critical_angle: 0.1, strength: 1, mirror: 1}}\n"
      "walls: [{points: [[0, 0], [9, 0], [9, 9]], material: ice}]\n"
      "posts: [{at: [5, 5], radius: 0.1}]\n"
      "boxes: [{at: [7, 7], size: [1, 0.5], yaw: 0.3}]\n"
      "tables: [{at: [3, 7], size: [1, 0.5]}]\n"
      "doors: [{name: d, hinge: [2, 0], latch: [3, 0], swing: -1, open: true}]\n"
      "chairs: [{name: c, at: [5, 7], yaw: 1}]\n"
      "bicycles: [{name: b, at: [2, 4]}]\n"
      "whiteboards: [{name: wb, from: [4, 0.03], to: [6, 0.03]}]\n"
      "places: [{label: a, at: [1, 1], links: [b]}, {label: b, at: [2, 2]}]\n",
      "w.yaml");
  EXPECT_EQ(world.walls[0].material.critical_angle, 0.1);
  EXPECT_EQ(world.walls[0].points.size(), 3U);
  EXPECT_EQ(world.posts.size(), 1U);
  EXPECT_EQ(world.boxes[0].pose.yaw, 0.3);
  EXPECT_EQ(world.tables.size(), 1U);
  EXPECT_TRUE(world.doors[0].open);
  EXPECT_EQ(world.doors[0].swing, -1.0);
  EXPECT_EQ(world.chairs[0].name, "c");
  EXPECT_EQ(world.bicycles.size(), 1U);
  EXPECT_EQ(world.whiteboards.size(), 1U);
  EXPECT_EQ(placeNeighbours(world)[1], std::vector<std::size_t>{0});
}

struct Shipped {
  const char* file;
  std::size_t places;
};

class ShippedWorld : public testing::TestWithParam<Shipped> {
 protected:
  World load() const {
    return loadWorld(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds/" + GetParam().file);
  }
};

TEST_P(ShippedWorld, HasItsPlacesAllFreeAndValid) {
  const World world = load();
  EXPECT_EQ(world.places.size(), GetParam().places);
  EXPECT_NO_THROW(validateWorld(world, kPlaceClearance));
}

TEST_P(ShippedWorld, LinksCanBeWalkedAndReachEveryPlace) {
  const World world = load();
  const Scene scene(world);
  const auto neighbours = placeNeighbours(world);
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    EXPECT_FALSE(neighbours[i].empty()) << world.places[i].label;
    for (const std::size_t j : neighbours[i]) {
      EXPECT_TRUE(scene.isPathFree(world.places[i].position, world.places[j].position, 0.25))
          << world.places[i].label << " to " << world.places[j].label;
    }
  }
  std::vector<std::size_t> reached = {0};
  std::vector<bool> seen(world.places.size(), false);
  seen[0] = true;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (const std::size_t j : neighbours[reached[next]]) {
      if (!seen[j]) reached.push_back(j);
      seen[j] = true;
    }
  }
  EXPECT_EQ(reached.size(), world.places.size());
}

INSTANTIATE_TEST_SUITE_P(Files, ShippedWorld,
                         testing::Values(Shipped{"rooms.yaml", 5}, Shipped{"office.yaml", 47},
                                         Shipped{"hallway.yaml", 21}));

}  // namespace
}  // namespace place_memory::sim
