#include "sim/building/wall_plan.h"

#include <algorithm>
#include <cmath>

namespace place_memory::sim {

namespace {

constexpr double kSameLine = 1e-6;

}  // namespace

SharedWall sharedWall(const Rect& a, const Rect& b) {
  const double x0 = std::max(a.x0, b.x0);
  const double x1 = std::min(a.x1, b.x1);
  const double y0 = std::max(a.y0, b.y0);
  const double y1 = std::min(a.y1, b.y1);
  const bool upright = y1 > y0 && std::fabs(x0 - x1) < kSameLine;
  const bool level = x1 > x0 && std::fabs(y0 - y1) < kSameLine;
  if (upright) return {{x0, y0}, {x0, y1}};
  if (level) return {{x0, y0}, {x1, y0}};
  return {{x0, y0}, {x0, y0}};
}

WallPlan::Line WallPlan::lineThrough(Vec2 from, Vec2 to) {
  const bool level = std::fabs(to.x - from.x) > std::fabs(to.y - from.y);
  return {level, std::lround((level ? from.y : from.x) * 1000.0)};
}

std::vector<WallPlan::Stretch> WallPlan::without(const Stretch& stretch, double from, double to) {
  std::vector<Stretch> rest;
  if (stretch.from < from)
    rest.push_back({stretch.from, std::min(stretch.to, from), stretch.material});
  if (stretch.to > to) rest.push_back({std::max(stretch.from, to), stretch.to, stretch.material});
  return rest;
}

void WallPlan::addStretch(Vec2 from, Vec2 to, const Material& material) {
  const Line line = lineThrough(from, to);
  const double a = line.first ? from.x : from.y;
  const double b = line.first ? to.x : to.y;
  std::vector<Stretch>& built = lines_[line];
  std::vector<Stretch> pending = {{std::min(a, b), std::max(a, b), material}};
  for (const Stretch& old : built) {
    std::vector<Stretch> rest;
    for (const Stretch& piece : pending) {
      for (const Stretch& left : without(piece, old.from, old.to)) rest.push_back(left);
    }
    pending = rest;
  }
  built.insert(built.end(), pending.begin(), pending.end());
}

void WallPlan::addRoom(const Rect& room, const Material& material) {
  addStretch({room.x0, room.y0}, {room.x1, room.y0}, material);
  addStretch({room.x0, room.y1}, {room.x1, room.y1}, material);
  addStretch({room.x0, room.y0}, {room.x0, room.y1}, material);
  addStretch({room.x1, room.y0}, {room.x1, room.y1}, material);
}

void WallPlan::addOpening(Vec2 from, Vec2 to) {
  const Line line = lineThrough(from, to);
  const double a = line.first ? from.x : from.y;
  const double b = line.first ? to.x : to.y;
  std::vector<Stretch> rest;
  for (const Stretch& stretch : lines_[line]) {
    for (const Stretch& left : without(stretch, std::min(a, b), std::max(a, b)))
      rest.push_back(left);
  }
  lines_[line] = rest;
}

std::vector<Wall> WallPlan::build() const {
  std::vector<Wall> walls;
  for (const auto& [line, stretches] : lines_) {
    const double level = static_cast<double>(line.second) * 1e-3;
    for (const Stretch& stretch : stretches) {
      if (stretch.to - stretch.from < 0.01) continue;
      if (line.first) {
        walls.push_back({{{stretch.from, level}, {stretch.to, level}}, stretch.material});
      } else {
        walls.push_back({{{level, stretch.from}, {level, stretch.to}}, stretch.material});
      }
    }
  }
  return walls;
}

}  // namespace place_memory::sim
