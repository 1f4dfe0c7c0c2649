#include "spliced_places.h"

#include <cmath>
#include <stdexcept>

#include "sim/world/random.h"

namespace place_memory::measure {
namespace {

using core::kGridSize;
using Cells = std::array<std::int8_t, core::kGridCells>;

constexpr int kLast = kGridSize - 1;

/// Nearest and farthest that the line of a splice passes by the middle of the grid [cells].
constexpr double kNearest = 4.0;
constexpr double kFarthest = 18.0;
/// Spliced buildings lie about on a map of this size [m].
constexpr double kMapSize = 1e5;

std::size_t cellOf(int row, int column) {
  const int cell = row * kGridSize + column;
  return static_cast<std::size_t>(cell);
}

/// For each cell of a turned, and perhaps then mirrored, grid the cell it comes from.
using Sources = std::array<std::uint16_t, core::kGridCells>;

Sources sourcesOf(int quarter_turns, bool mirrored) {
  Sources sources;
  for (int to_row = 0; to_row < kGridSize; ++to_row) {
    for (int to_column = 0; to_column < kGridSize; ++to_column) {
      int row = to_row;
      int column = mirrored ? kLast - to_column : to_column;
      for (int i = 0; i < quarter_turns; ++i) {
        const int turned = kLast - row;
        row = column;
        column = turned;
      }
      sources[cellOf(to_row, to_column)] = static_cast<std::uint16_t>(cellOf(row, column));
    }
  }
  return sources;
}

Cells transformed(const Cells& cells, int quarter_turns, bool mirrored) {
  static const std::array<Sources, 8> kSources = [] {
    std::array<Sources, 8> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = sourcesOf(static_cast<int>(i / 2), i % 2);
    return all;
  }();
  const int symmetry = 2 * quarter_turns + (mirrored ? 1 : 0);
  const Sources& sources = kSources[static_cast<std::size_t>(symmetry)];
  Cells result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = cells[sources[i]];
  return result;
}

/// `other` beyond a line at random, `cells` before it.
void splice(const Cells& other, sim::Rng& rng, Cells& cells) {
  const double direction = sim::uniform(rng, -core::kPi, core::kPi);
  const double distance = sim::uniform(rng, kNearest, kFarthest);
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      if (c * (column - 0.5 * kLast) + s * (row - 0.5 * kLast) <= distance) continue;
      const std::size_t cell = cellOf(row, column);
      cells[cell] = other[cell];
    }
  }
}

}  // namespace

SplicedPlaces::SplicedPlaces(const std::vector<KnownPlace>& simulated, std::size_t first_building)
    : simulated_(simulated) {
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    if (simulated[i].building < first_building) continue;
    if (i == 0 || simulated[i].building != simulated[i - 1].building || buildings_.empty()) {
      buildings_.push_back({i, 0});
    }
    ++buildings_.back().count;
  }
  if (buildings_.empty()) throw std::invalid_argument("there is no building to splice");
}

KnownPlace SplicedPlaces::make(std::uint64_t number) const {
  sim::Rng rng(number);
  const Building& building = buildings_[sim::uniformIndex(rng, buildings_.size())];
  const KnownPlace& one = simulated_[building.first + sim::uniformIndex(rng, building.count)];
  const KnownPlace& other = simulated_[building.first + sim::uniformIndex(rng, building.count)];
  Cells cells = one.grid.cells();
  splice(transformed(other.grid.cells(), sim::uniformInt(rng, 0, 3), false), rng, cells);
  KnownPlace place;
  place.building = one.building;
  place.map_from_place.x = sim::uniform(rng, -kMapSize, 0.0);
  place.map_from_place.y = sim::uniform(rng, -kMapSize, kMapSize);
  const int quarter_turns = sim::uniformInt(rng, 0, 3);
  place.grid.cells() = transformed(cells, quarter_turns, sim::chance(rng, 0.5));
  return place;
}

}  // namespace place_memory::measure
