#include "sim/building/building_draft.h"

#include <algorithm>
#include <numeric>

namespace place_memory::sim {

namespace {

Material randomWall(Rng& rng) {
  const double kind = uniform(rng);
  if (kind < 0.65)
    return {uniform(rng, 0.14, 0.45), uniform(rng, 0.8, 1.0), uniform(rng, 0.75, 0.92)};
  if (kind < 0.85) return {uniform(rng, 0.4, 1.0), uniform(rng, 0.6, 0.85), uniform(rng, 0.3, 0.7)};
  if (kind < 0.92) return standardMaterials().at("glass");
  return standardMaterials().at("cloth");
}

}  // namespace

Style randomStyle(Rng& rng) {
  return {randomWall(rng), uniform(rng, 0.0, 0.5), uniform(rng, 0.15, 0.85),
          uniform(rng, 0.2, 1.6)};
}

Material BuildingDraft::wallMaterial() {
  return chance(rng_, style_.wall_variety) ? randomWall(rng_) : style_.wall;
}

void BuildingDraft::addRoom(const Rect& rect, RoomUse use) {
  rooms_.push_back({rect, use});
  walls_.addRoom(rect, wallMaterial());
}

bool BuildingDraft::addDoor(const SharedWall& wall) {
  const double length = norm(wall.to - wall.from);
  const double width = uniform(rng_, 0.75, 1.0);
  if (length < width + 0.3) return false;
  const Vec2 along = (wall.to - wall.from) * (1.0 / length);
  const double recess = chance(rng_, 0.5) ? uniform(rng_, -0.1, 0.1) : 0.0;
  const Vec2 start =
      wall.from + along * uniform(rng_, 0.1, length - width - 0.1) + leftOf(along) * recess;
  Vec2 hinge = start;
  Vec2 latch = start + along * width;
  if (chance(rng_, 0.5)) std::swap(hinge, latch);
  const char* kinds[] = {"wood", "wood", "wood", "metal", "glass"};
  const double swing = (chance(rng_, 0.5) ? 1.0 : -1.0) * uniform(rng_, 1.2, 1.7);
  world_.doors.push_back({nextName("door"), hinge, latch, swing, chance(rng_, style_.doors_open),
                          standardMaterials().at(kinds[uniformIndex(rng_, 5)])});
  occupy((hinge + latch) * 0.5, 0.85);
  return true;
}

bool BuildingDraft::addGap(const SharedWall& wall, bool whole) {
  const double length = norm(wall.to - wall.from);
  if (length < 0.9) return false;
  const double width = whole ? length : std::min(length - 0.1, uniform(rng_, 0.8, 1.8));
  const Vec2 along = (wall.to - wall.from) * (1.0 / length);
  const Vec2 start = wall.from + along * uniform(rng_, 0.0, length - width);
  walls_.addOpening(start, start + along * width);
  occupy(start + along * (0.5 * width), 0.7);
  return true;
}

void BuildingDraft::connectRooms(double gap_chance, double extra_chance) {
  std::vector<std::size_t> group(rooms_.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    for (std::size_t j = i + 1; j < rooms_.size(); ++j) pairs.emplace_back(i, j);
  }
  shuffle(pairs, rng_);
  for (const auto& [i, j] : pairs) {
    const SharedWall wall = sharedWall(rooms_[i].rect, rooms_[j].rect);
    if (norm(wall.to - wall.from) < 1.3) continue;
    if (group[i] == group[j] && !chance(rng_, extra_chance)) continue;
    const bool joined = chance(rng_, gap_chance) ? addGap(wall, false) : addDoor(wall);
    if (!joined) continue;
    const std::size_t old = group[j];
    for (std::size_t& member : group) {
      if (member == old) member = group[i];
    }
  }
}

bool BuildingDraft::hasRoom(Vec2 center, double radius) const {
  return std::all_of(occupied_.begin(), occupied_.end(), [&](const Disc& disc) {
    return norm(disc.center - center) > disc.radius + radius;
  });
}

World BuildingDraft::finish() {
  std::vector<Wall> walls = walls_.build();
  walls.insert(walls.end(), world_.walls.begin(), world_.walls.end());
  world_.walls = std::move(walls);
  return std::move(world_);
}

}  // namespace place_memory::sim
