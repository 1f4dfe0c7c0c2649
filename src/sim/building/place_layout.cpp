#include "sim/building/place_layout.h"

#include <algorithm>
#include <string>

#include "sim/scene/scene.h"

namespace place_memory::sim {

namespace {

using Graph = std::vector<std::vector<std::size_t>>;

// Free spots about one to a lattice cell; where the middle of a cell is taken, ever farther off it.
std::vector<Vec2> spotsIn(const Scene& scene, const Rect& room, const PlaceSpacing& spacing,
                          Rng& rng) {
  constexpr int kAttempts = 12;
  const auto count = [&](double side) {
    return std::max(1, static_cast<int>(side / spacing.distance));
  };
  const int columns = count(room.width());
  const int rows = count(room.height());
  const Vec2 cell{room.width() / columns, room.height() / rows};
  const Vec2 room_to_move{std::max(0.0, 0.5 * cell.x - spacing.clearance),
                          std::max(0.0, 0.5 * cell.y - spacing.clearance)};
  std::vector<Vec2> spots;
  for (int i = 0; i < columns * rows; ++i) {
    const int column = i % columns;
    const int row = i / columns;
    const Vec2 middle{room.x0 + (column + 0.5) * cell.x, room.y0 + (row + 0.5) * cell.y};
    for (int attempt = 1; attempt <= kAttempts; ++attempt) {
      const double reach = static_cast<double>(attempt) / kAttempts;
      const Vec2 spot = middle + Vec2{room_to_move.x * uniform(rng, -reach, reach),
                                      room_to_move.y * uniform(rng, -reach, reach)};
      if (!scene.isFree(spot, spacing.clearance)) continue;
      spots.push_back(spot);
      break;
    }
  }
  return spots;
}

Graph linkSpots(const World& world, const std::vector<Vec2>& spots, const PlaceSpacing& spacing) {
  World opened = world;
  for (Door& door : opened.doors) door.open = true;
  const Scene scene(opened);
  Graph links(spots.size());
  for (std::size_t i = 0; i < spots.size(); ++i) {
    for (std::size_t j = i + 1; j < spots.size(); ++j) {
      if (norm(spots[i] - spots[j]) > 1.9 * spacing.distance) continue;
      if (!scene.isPathFree(spots[i], spots[j], 0.6 * spacing.clearance)) continue;
      links[i].push_back(j);
      links[j].push_back(i);
    }
  }
  return links;
}

// What can be reached from `start`, nearest first.
std::vector<std::size_t> reachable(const Graph& links, std::size_t start) {
  std::vector<bool> seen(links.size(), false);
  std::vector<std::size_t> order = {start};
  seen[start] = true;
  for (std::size_t next = 0; next < order.size(); ++next) {
    for (const std::size_t neighbour : links[order[next]]) {
      if (seen[neighbour]) continue;
      seen[neighbour] = true;
      order.push_back(neighbour);
    }
  }
  return order;
}

std::vector<std::size_t> chooseConnected(const Graph& links, std::size_t most, Rng& rng) {
  std::vector<std::size_t> best;
  for (int attempt = 0; attempt < 8 && !links.empty() && best.size() < most; ++attempt) {
    std::vector<std::size_t> part = reachable(links, uniformIndex(rng, links.size()));
    if (part.size() > best.size()) best = std::move(part);
  }
  if (best.size() > most) best.resize(most);
  return best;
}

}  // namespace

void layPlaces(World& world, const std::vector<Room>& rooms, const PlaceSpacing& spacing,
               Rng& rng) {
  const Scene scene(world);
  std::vector<Vec2> spots;
  for (const Room& room : rooms) {
    const std::vector<Vec2> found = spotsIn(scene, room.rect, spacing, rng);
    spots.insert(spots.end(), found.begin(), found.end());
  }
  const Graph links = linkSpots(world, spots, spacing);
  const std::vector<std::size_t> chosen = chooseConnected(links, spacing.most, rng);
  std::vector<std::string> labels(spots.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) labels[chosen[i]] = std::to_string(i);
  world.places.clear();
  for (const std::size_t spot : chosen) {
    Place place{labels[spot], spots[spot], {}};
    for (const std::size_t other : links[spot]) {
      if (other > spot && !labels[other].empty()) place.links.push_back(labels[other]);
    }
    world.places.push_back(place);
  }
}

}  // namespace place_memory::sim
