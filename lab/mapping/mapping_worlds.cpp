#include "mapping/mapping_worlds.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "sim/building/building_generator.h"
#include "sim/scene/world_loader.h"
#include "sim/world/random.h"

namespace place_memory::mapping {
namespace {

void addPlace(sim::World& world, sim::Vec2 spot, std::vector<std::size_t> links) {
  sim::Place place;
  place.label = "p" + std::to_string(world.places.size());
  place.position = spot;
  for (const std::size_t link : links) place.links.push_back("p" + std::to_string(link));
  world.places.push_back(std::move(place));
}

void addBox(sim::World& world, double x, double y, double width, double depth) {
  world.boxes.push_back({{x, y, 0.0}, width, depth, {}});
}

}  // namespace

sim::World halfTurnRoom() {
  sim::World world;
  world.name = "half_turn";
  world.walls.push_back(
      {{{-5.5, -3.75}, {5.5, -3.75}, {5.5, 3.75}, {-5.5, 3.75}, {-5.5, -3.75}}, {}});
  addBox(world, 0.3, 0.2, 4.5, 1.2);
  addBox(world, -4.6, 3.0, 1.2, 0.8);
  addBox(world, 4.9, -2.4, 0.8, 1.6);
  addBox(world, 1.5, 3.4, 2.0, 0.5);
  addBox(world, -2.2, -3.3, 1.1, 0.7);
  addBox(world, -5.1, -1.0, 0.6, 1.0);
  const std::vector<sim::Vec2> ring{{-3.3, -2.0}, {0.0, -2.0}, {3.5, -2.0}, {4.0, 0.2},
                                    {3.5, 2.0},   {0.0, 2.1},  {-3.3, 1.9}, {-3.6, 0.2}};
  for (std::size_t i = 0; i < ring.size(); ++i) addPlace(world, ring[i], {(i + 1) % ring.size()});
  return world;
}

sim::World alikeCells(int cells, std::uint64_t seed, double copied) {
  constexpr double kCell = 4.0, kDoor = 1.0, kHalfWidth = 0.9;
  std::seed_seq sequence{seed, seed >> 32U, std::uint64_t{0xce11}};
  sim::Rng rng(sequence);
  sim::World world;
  world.name = "cells";
  const double length = kCell * cells;
  for (const double side : {-1.0, 1.0}) {
    const double wall = side * kHalfWidth, back = side * (kHalfWidth + kCell);
    world.walls.push_back({{{0.0, wall}, {0.0, back}, {length, back}, {length, wall}}, {}});
    for (int i = 0; i < cells; ++i) {
      const double x = kCell * i;
      const double door = x + 0.5 * (kCell - kDoor);
      world.walls.push_back({{{x, wall}, {door, wall}}, {}});
      world.walls.push_back({{{door + kDoor, wall}, {x + kCell, wall}}, {}});
      if (i > 0) world.walls.push_back({{{x, wall}, {x, back}}, {}});
      // A desk along the back wall and a cabinet, where each person likes them.
      double desk = sim::uniform(rng, 1.2, 2.8);
      bool left = sim::uniform(rng) < 0.5;
      double cabinet = sim::uniform(rng, 0.9, 2.4);
      if (copied > 0.0 && sim::uniform(rng) < copied) {
        desk = 2.0;
        left = true;
        cabinet = 1.6;
      }
      addBox(world, x + desk, back - side * 0.5, 1.6, 0.8);
      addBox(world, left ? x + 0.35 : x + kCell - 0.35, wall + side * cabinet, 0.5, 0.9);
    }
  }
  world.walls.push_back({{{0.0, -kHalfWidth}, {0.0, kHalfWidth}}, {}});
  world.walls.push_back({{{length, -kHalfWidth}, {length, kHalfWidth}}, {}});
  for (int i = 0; i < cells; ++i) {
    const double x = kCell * (i + 0.5);
    const std::size_t middle = world.places.size();
    addPlace(world, {x, 0.0}, i == 0 ? std::vector<std::size_t>{} : std::vector{middle - 3});
    addPlace(world, {x, kHalfWidth + 1.6}, {middle});
    addPlace(world, {x, -kHalfWidth - 1.6}, {middle});
  }
  return world;
}

sim::World mappingWorld(const std::string& name, std::uint64_t seed, const std::string& worlds) {
  static const std::map<std::string, sim::BuildingKind> kKinds{
      {"corridor", sim::BuildingKind::kCorridor},
      {"open_plan", sim::BuildingKind::kOpenPlan},
      {"laboratory", sim::BuildingKind::kLaboratory},
      {"home", sim::BuildingKind::kHome}};
  if (name == "half_turn") return halfTurnRoom();
  if (name == "cells") return alikeCells(6, seed);
  if (name == "copied_cells") return alikeCells(10, seed, 0.8);
  const auto kind = kKinds.find(name);
  if (kind != kKinds.end()) return sim::generateBuilding(kind->second, seed);
  if (name.find(".yaml") != std::string::npos) return sim::loadWorld(name);
  return sim::loadWorld(worlds + "/" + name + ".yaml");
}

}  // namespace place_memory::mapping
