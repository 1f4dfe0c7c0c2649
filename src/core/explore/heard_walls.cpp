#include "core/explore/heard_walls.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kTrusted = 2.5;  // echoes from further off may have come around corners [m]
constexpr double kFan = 0.25;     // rays beside the axis, in shares of half a cone
constexpr int kEnoughEchoes = 2;
constexpr double kNearer = 0.6;  // times as far off, what was heard counts instead

std::int64_t cellOf(double coordinate, double resolution) {
  return static_cast<std::int64_t>(std::floor(coordinate / resolution));
}

void increase(std::uint8_t& counter) {
  if (counter < 255) ++counter;
}

}  // namespace

HeardWalls::At HeardWalls::at(double x, double y) const {
  const std::int64_t column = cellOf(x, resolution_), row = cellOf(y, resolution_);
  const auto floored = [](std::int64_t a) {
    return a >= 0 ? a / kTile : -((kTile - 1 - a) / kTile);
  };
  const std::int64_t tile_column = floored(column), tile_row = floored(row);
  return {
      tile_row * (std::int64_t{1} << 32) + tile_column,
      static_cast<std::size_t>((row - tile_row * kTile) * kTile + column - tile_column * kTile)};
}

HeardWalls::Cell& HeardWalls::cell(double x, double y) {
  const At found = at(x, y);
  return tiles_[found.tile][found.cell];
}

void HeardWalls::add(const Pose2d& map_from_sensor, const SonarSpec& spec, double range) {
  for (const double side : {-kFan, 0.0, kFan}) {
    const double bearing = map_from_sensor.yaw + 0.5 * side * spec.field_of_view;
    const double turns = bearing / (2.0 * kPi);
    const auto bin = static_cast<std::size_t>((turns - std::floor(turns)) * kBearings) % kBearings;
    const double c = std::cos(bearing), s = std::sin(bearing);
    // A whole cell before the echo may be its own.
    const double passed = std::min(range, kTrusted) - resolution_;
    for (double way = 0.0; way < passed; way += resolution_) {
      count(map_from_sensor.x + way * c, map_from_sensor.y + way * s, bin, way, false);
    }
    if (range > kTrusted) continue;
    count(map_from_sensor.x + range * c, map_from_sensor.y + range * s, bin, range, true);
  }
}

void HeardWalls::count(double x, double y, std::size_t bin, double distance, bool is_echo) {
  Cell& heard = cell(x, y);
  const double cells = 1.0 + distance / resolution_;
  // What passes a cell tells of its neighbouring bearings as well.
  for (const std::size_t i : {bin, (bin + 1) % kBearings, (bin + kBearings - 1) % kBearings}) {
    if (is_echo && i != bin) continue;
    if (cells >= kNearer * heard.from[i]) continue;
    heard.echoes[i] = 0;
    heard.passes[i] = 0;
    heard.from[i] = 0;
  }
  std::uint8_t& from = heard.from[bin];
  if (from > 0 && kNearer * cells > from) return;
  if (from == 0 || cells < from) from = static_cast<std::uint8_t>(std::min(cells, 255.0));
  increase(is_echo ? heard.echoes[bin] : heard.passes[bin]);
}

void HeardWalls::clearAround(double x, double y, double radius) {
  for (double dy = -radius; dy <= radius; dy += resolution_) {
    for (double dx = -radius; dx <= radius; dx += resolution_) {
      if (std::hypot(dx, dy) <= radius) cell(x + dx, y + dy).echoes.fill(0);
    }
  }
}

bool HeardWalls::isWall(double x, double y) const {
  const At found = at(x, y);
  const auto tile = tiles_.find(found.tile);
  if (tile == tiles_.end()) return false;
  const Cell& cell = tile->second[found.cell];
  for (std::size_t i = 0; i < kBearings; ++i) {
    if (cell.echoes[i] >= kEnoughEchoes && cell.echoes[i] > cell.passes[i]) return true;
  }
  return false;
}

}  // namespace place_memory::core
