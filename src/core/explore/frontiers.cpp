#include "core/explore/frontiers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace place_memory::core {
namespace {

using Cell = FreeSpace::Cell;
using Cells = std::vector<Cell>;

bool isFrontier(const FreeSpace& space, Cell cell, const std::vector<MapDisc>& looked_at) {
  if (!space.isPassable(cell)) return false;
  bool is_at_rim = false;
  space.forEachNeighbour(cell, [&](Cell next, bool is_across) {
    if (!is_across && space.state(next) == FreeSpace::State::kUnknown) is_at_rim = true;
  });
  if (!is_at_rim) return false;
  const Pose2d at = space.centre(cell);
  return std::none_of(looked_at.begin(), looked_at.end(), [&](const MapDisc& disc) {
    return std::hypot(at.x - disc.x, at.y - disc.y) < disc.radius;
  });
}

/// The cells that hang together with `first`, which are no longer marked then.
Cells cluster(const FreeSpace& space, Cell first, std::vector<std::uint8_t>& marked) {
  Cells cells{first};
  marked[first] = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    space.forEachNeighbour(cells[i], [&](Cell next, bool) {
      if (marked[next] == 0) return;
      marked[next] = 0;
      cells.push_back(next);
    });
  }
  return cells;
}

Cell middleOf(const FreeSpace& space, const Cells& cells) {
  double x = 0.0, y = 0.0;
  for (const Cell cell : cells) {
    const Pose2d at = space.centre(cell);
    x += at.x / static_cast<double>(cells.size());
    y += at.y / static_cast<double>(cells.size());
  }
  const auto off = [&](Cell cell) {
    const Pose2d at = space.centre(cell);
    return std::hypot(at.x - x, at.y - y);
  };
  return *std::min_element(cells.begin(), cells.end(),
                           [&](Cell one, Cell other) { return off(one) < off(other); });
}

double widthOf(const FreeSpace& space, const Cells& cells) {
  const auto furthest = [&](Cell from) {
    return *std::max_element(cells.begin(), cells.end(), [&](Cell one, Cell other) {
      return space.distance(from, one) < space.distance(from, other);
    });
  };
  const Cell end = furthest(cells.front());
  return space.distance(end, furthest(end)) + space.resolution();
}

/// Unknown ground that hangs together with the cell, is not walled off from it and was never in
/// sight.
double opening(const FreeSpace& space, Cell from, double looks_out,
               const std::vector<std::uint8_t>& in_sight) {
  Cells seen{from};
  std::vector<std::uint8_t> is_seen(space.size(), 0);
  is_seen[from] = 1;
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    space.forEachNeighbour(seen[i], [&](Cell next, bool is_across) {
      if (is_across || is_seen[next] != 0 || space.state(next) != FreeSpace::State::kUnknown ||
          space.distance(from, next) > looks_out) {
        return;
      }
      is_seen[next] = 1;
      if (in_sight[next] == 0) ++unknown;
      seen.push_back(next);
    });
  }
  return static_cast<double>(unknown) * space.resolution() * space.resolution();
}

/// In pieces no wider than that, by which of some seeds each cell is nearest to.
std::vector<Cells> pieces(const FreeSpace& space, const Cells& cells, double widest) {
  const auto count = static_cast<std::size_t>(std::ceil(widthOf(space, cells) / widest));
  if (count < 2) return {cells};
  Cells seeds{cells.front()};
  while (seeds.size() < count) {
    const auto off = [&](Cell cell) {
      double nearest = INFINITY;
      for (const Cell seed : seeds) nearest = std::min(nearest, space.distance(seed, cell));
      return nearest;
    };
    seeds.push_back(*std::max_element(cells.begin(), cells.end(),
                                      [&](Cell one, Cell other) { return off(one) < off(other); }));
  }
  std::vector<Cells> parts(seeds.size());
  for (const Cell cell : cells) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < seeds.size(); ++i) {
      if (space.distance(seeds[i], cell) < space.distance(seeds[nearest], cell)) nearest = i;
    }
    parts[nearest].push_back(cell);
  }
  return parts;
}

}  // namespace

std::vector<Frontier> frontiersOf(const FreeSpace& space, const FrontierOptions& options,
                                  const std::vector<MapDisc>& looked_at,
                                  const std::vector<std::uint8_t>& in_sight) {
  std::vector<std::uint8_t> marked(space.size(), 0);
  for (Cell cell = 0; cell < space.size(); ++cell) {
    marked[cell] = isFrontier(space, cell, looked_at) ? 1 : 0;
  }
  std::vector<Frontier> frontiers;
  for (Cell cell = 0; cell < space.size(); ++cell) {
    if (marked[cell] == 0) continue;
    const Cells whole = cluster(space, cell, marked);
    if (widthOf(space, whole) < options.least_width) continue;
    for (const Cells& part : pieces(space, whole, options.widest)) {
      Frontier frontier;
      frontier.cell = middleOf(space, part);
      frontier.width = widthOf(space, part);
      frontier.opens = opening(space, frontier.cell, options.looks_out, in_sight);
      if (frontier.opens >= options.least_opens) frontiers.push_back(frontier);
    }
  }
  return frontiers;
}

}  // namespace place_memory::core
