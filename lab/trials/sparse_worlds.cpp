#include "trials/sparse_worlds.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/scene/scene.h"

namespace place_memory::trials {
namespace {

using sim::chance;
using sim::Rng;
using sim::uniform;
using sim::Vec2;

constexpr double kClearance = 0.5;  // [m]
constexpr double kSpacing = 2.0;    // between places [m]

sim::Material anyMaterial(Rng& rng) {
  const auto& table = sim::standardMaterials();
  auto chosen = table.begin();
  std::advance(chosen, static_cast<std::ptrdiff_t>(sim::uniformIndex(rng, table.size())));
  return chosen->second;
}

void wallIn(double width, double depth, Rng& rng, sim::World& world) {
  world.walls.push_back(
      {{{0.0, 0.0}, {width, 0.0}, {width, depth}, {0.0, depth}, {0.0, 0.0}}, anyMaterial(rng)});
}

void addThing(Vec2 at, Rng& rng, sim::World& world) {
  const core::Pose2d pose{at.x, at.y, uniform(rng, -core::kPi, core::kPi)};
  switch (sim::uniformInt(rng, 0, 2)) {
    case 0:
      world.posts.push_back({at, uniform(rng, 0.04, 0.3), anyMaterial(rng)});
      break;
    case 1:
      world.boxes.push_back(
          {pose, uniform(rng, 0.3, 2.0), uniform(rng, 0.3, 1.0), anyMaterial(rng)});
      break;
    default:
      world.chairs.push_back({"chair " + std::to_string(world.chairs.size()), pose});
  }
}

/// Places in the rectangle about `centre` where there is room to stand.
void layPlaces(Vec2 centre, Vec2 half, std::size_t count, Rng& rng, sim::World& world) {
  const sim::Scene scene(world);
  constexpr int kTries = 40;
  for (std::size_t i = 0; i < count * kTries && world.places.size() < count; ++i) {
    const Vec2 at{centre.x + uniform(rng, -half.x, half.x),
                  centre.y + uniform(rng, -half.y, half.y)};
    const bool crowded =
        std::any_of(world.places.begin(), world.places.end(), [&](const sim::Place& place) {
          return std::hypot(place.position.x - at.x, place.position.y - at.y) < kSpacing;
        });
    if (crowded || !scene.isFree(at, kClearance)) continue;
    world.places.push_back({"open " + std::to_string(world.places.size()), at, {}});
  }
}

}  // namespace

sim::World openSpace(std::size_t places, Rng& rng) {
  sim::World world;
  world.name = "open space";
  const double width = uniform(rng, 25.0, 60.0), depth = uniform(rng, 25.0, 60.0);
  wallIn(width, depth, rng, world);
  const Vec2 centre{0.5 * width, 0.5 * depth};
  const Vec2 half{0.5 * width - 8.0, 0.5 * depth - 8.0};
  const double density = chance(rng, 0.5) ? uniform(rng, 0.0, 0.005) : uniform(rng, 0.005, 0.04);
  const int things = static_cast<int>(4.0 * half.x * half.y * density);
  for (int i = 0; i < things; ++i) {
    addThing({centre.x + uniform(rng, -half.x, half.x), centre.y + uniform(rng, -half.y, half.y)},
             rng, world);
  }
  layPlaces(centre, half, places, rng, world);
  return world;
}

sim::World hall(std::size_t places, Rng& rng) {
  sim::World world;
  world.name = "hall";
  const double width = uniform(rng, 8.0, 20.0), depth = uniform(rng, 8.0, 20.0);
  wallIn(width, depth, rng, world);
  const int things = sim::uniformInt(rng, 0, 12);
  for (int i = 0; i < things; ++i) {
    const double side = chance(rng, 0.5) ? 0.5 : depth - 0.5;
    addThing({uniform(rng, 1.0, width - 1.0), side}, rng, world);
  }
  if (chance(rng, 0.5)) {
    const double spacing = uniform(rng, 3.0, 6.0);
    const double radius = uniform(rng, 0.1, 0.3);
    const sim::Material material = anyMaterial(rng);
    for (double x = spacing; x < width - 1.0; x += spacing) {
      for (double y = spacing; y < depth - 1.0; y += spacing) {
        world.posts.push_back({{x, y}, radius, material});
      }
    }
  }
  layPlaces({0.5 * width, 0.5 * depth}, {0.5 * width - 1.0, 0.5 * depth - 1.0}, places, rng, world);
  return world;
}

}  // namespace place_memory::trials
