#include "sim/scene/world_changes.h"

#include <algorithm>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/scene/scene_builder.h"
#include "sim/scene/world_loader.h"

namespace place_memory::sim {

namespace {

constexpr double kChairRadius = 0.32;
constexpr double kChairDistance = 1.83;  // six feet, paper section 5 [m]
constexpr double kHandlebar = 0.3;       // half the width of a bicycle [m]
constexpr double kGap = 0.05;            // left beside furniture [m]
constexpr int kAttempts = 40;

bool coversPlace(const World& world, Vec2 point, double radius) {
  return std::any_of(world.places.begin(), world.places.end(), [&](const Place& place) {
    return norm(place.position - point) <= radius + kPlaceClearance;
  });
}

std::string freshName(const std::string& stem, std::size_t number) {
  return stem + "_" + std::to_string(number);
}

template <typename T>
std::string unusedName(const std::vector<T>& items, const std::string& stem) {
  std::size_t number = items.size();
  const auto taken = [&](const std::string& name) {
    return std::any_of(items.begin(), items.end(),
                       [&](const T& item) { return item.name == name; });
  };
  while (taken(freshName(stem, number))) ++number;
  return freshName(stem, number);
}

std::size_t share(std::size_t count, double fraction) {
  const double wanted = std::round(fraction * static_cast<double>(count));
  return static_cast<std::size_t>(std::min(std::max(wanted, 0.0), static_cast<double>(count)));
}

std::vector<std::size_t> drawn(std::size_t count, std::size_t wanted, Rng& rng) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  shuffle(order, rng);
  order.resize(wanted);
  return order;
}

// Furniture as the line from end to end that is as thick as its shorter side.
template <typename T>
bool fits(const T& item, const Scene& others, const World& world) {
  const bool along_x = item.width >= item.depth;
  const double half = 0.5 * std::abs(item.width - item.depth);
  const double radius = 0.5 * std::min(item.width, item.depth);
  const Vec2 along = unitVector(item.pose.yaw + (along_x ? 0.0 : 0.5 * core::kPi)) * half;
  const Vec2 centre{item.pose.x, item.pose.y};
  if (!others.isPathFree(centre - along, centre + along, radius + kGap)) return false;
  return std::none_of(world.places.begin(), world.places.end(), [&](const Place& place) {
    return distanceToSegment(place.position, centre - along, centre + along) <=
           kPlaceClearance + radius * std::sqrt(2.0);
  });
}

// Moves item `i` of a list of the world's.
template <typename T>
bool moveItem(World& world, std::vector<T> World::*list, std::size_t i, double distance, Rng& rng) {
  World without = world;
  (without.*list).erase((without.*list).begin() + static_cast<std::ptrdiff_t>(i));
  const Scene others(without);
  T& item = (world.*list)[i];
  const Vec2 from{item.pose.x, item.pose.y};
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Vec2 to = from + unitVector(uniform(rng, 0.0, 2.0 * core::kPi)) *
                               (distance * std::sqrt(uniform(rng)));
    T moved = item;
    moved.pose = {to.x, to.y, uniform(rng, -core::kPi, core::kPi)};
    if (!fits(moved, others, world) || !others.isPathFree(from, to, kGap)) continue;
    item = moved;
    return true;
  }
  return false;
}

}  // namespace

int addChairs(World& world, Vec2 around, int count, Rng& rng) {
  const double first = uniform(rng, 0.0, 2.0 * core::kPi);
  int added = 0;
  for (int i = 0; i < count; ++i) {
    const Scene scene(world);
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const double loosened = static_cast<double>(attempt) / kAttempts;
      const double bearing = first + 2.0 * core::kPi * i / count +
                             loosened * uniform(rng, -core::kPi, core::kPi) / count;
      const double distance = kChairDistance + (0.1 + 0.7 * loosened) * uniform(rng, -1.0, 1.0);
      const Vec2 spot = around + unitVector(bearing) * distance;
      if (!scene.isFree(spot, kChairRadius) || coversPlace(world, spot, kChairRadius)) continue;
      if (!scene.isPathFree(around + unitVector(bearing) * 0.3, spot, 0.05)) continue;
      world.chairs.push_back({unusedName(world.chairs, "added_chair"),
                              {spot.x, spot.y, uniform(rng, -core::kPi, core::kPi)}});
      ++added;
      break;
    }
  }
  return added;
}

int flipDoors(World& world, double fraction, Rng& rng) {
  int flipped = 0;
  for (const std::size_t i : drawn(world.doors.size(), share(world.doors.size(), fraction), rng)) {
    Door changed = world.doors[i];
    changed.open = !changed.open;
    const Vec2 edge = doorEdge(changed);
    const bool blocked =
        std::any_of(world.places.begin(), world.places.end(), [&](const Place& place) {
          return distanceToSegment(place.position, changed.hinge, edge) <= kPlaceClearance;
        });
    if (blocked) continue;
    world.doors[i] = changed;
    ++flipped;
  }
  return flipped;
}

int moveChairs(World& world, double fraction, double distance, Rng& rng) {
  int moved = 0;
  for (const std::size_t i :
       drawn(world.chairs.size(), share(world.chairs.size(), fraction), rng)) {
    World others = world;
    others.chairs.erase(others.chairs.begin() + static_cast<std::ptrdiff_t>(i));
    const Scene scene(others);
    const core::Pose2d from = world.chairs[i].pose;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const Vec2 to = Vec2{from.x, from.y} + unitVector(uniform(rng, 0.0, 2.0 * core::kPi)) *
                                                 (distance * std::sqrt(uniform(rng)));
      if (!scene.isFree(to, kChairRadius) || coversPlace(world, to, kChairRadius)) continue;
      if (!scene.isPathFree({from.x, from.y}, to, 0.05)) continue;
      world.chairs[i].pose = {to.x, to.y, uniform(rng, -core::kPi, core::kPi)};
      ++moved;
      break;
    }
  }
  return moved;
}

int moveFurniture(World& world, double fraction, double distance, Rng& rng) {
  const std::size_t count = world.boxes.size() + world.tables.size();
  int moved = 0;
  for (const std::size_t i : drawn(count, share(count, fraction), rng)) {
    const bool is_box = i < world.boxes.size();
    const bool has_moved =
        is_box ? moveItem(world, &World::boxes, i, distance, rng)
               : moveItem(world, &World::tables, i - world.boxes.size(), distance, rng);
    if (has_moved) ++moved;
  }
  return moved;
}

int addBicycles(World& world, int count, Rng& rng) {
  int added = 0;
  for (int attempt = 0; attempt < kAttempts * count && added < count; ++attempt) {
    if (world.places.empty()) break;
    const Vec2 near = world.places[uniformIndex(rng, world.places.size())].position;
    const Vec2 spot =
        near + unitVector(uniform(rng, 0.0, 2.0 * core::kPi)) * uniform(rng, 0.8, 2.0);
    const double yaw = uniform(rng, -core::kPi, core::kPi);
    const Vec2 half = unitVector(yaw) * 0.85;
    const Scene scene(world);
    if (!scene.isPathFree(spot - half, spot + half, kHandlebar)) continue;
    if (!scene.isPathFree(near, spot, 0.05)) continue;
    const bool covers = std::any_of(world.places.begin(), world.places.end(), [&](const Place& p) {
      return distanceToSegment(p.position, spot - half, spot + half) <=
             kPlaceClearance + kHandlebar;
    });
    if (covers) continue;
    world.bicycles.push_back({unusedName(world.bicycles, "added_bicycle"), {spot.x, spot.y, yaw}});
    ++added;
  }
  return added;
}

bool removeWhiteboard(World& world, const std::string& name) {
  const auto it = std::find_if(world.whiteboards.begin(), world.whiteboards.end(),
                               [&](const Whiteboard& board) { return board.name == name; });
  if (it == world.whiteboards.end()) return false;
  world.whiteboards.erase(it);
  return true;
}

bool setDoor(World& world, const std::string& name, bool open) {
  Door* door = findDoor(world, name);
  if (door == nullptr) return false;
  door->open = open;
  return true;
}

bool moveChair(World& world, const std::string& name, const core::Pose2d& pose) {
  Chair* chair = findChair(world, name);
  if (chair == nullptr) return false;
  chair->pose = pose;
  return true;
}

}  // namespace place_memory::sim
