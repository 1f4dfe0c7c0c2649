#ifndef PLACE_MEMORY_CORE_EXPLORE_HEARD_WALLS_H
#define PLACE_MEMORY_CORE_EXPLORE_HEARD_WALLS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

/// What was heard to stand where by bearing. A smooth wall answers only who looks at it head on,
/// and to all others seems open: on a map that sums up what all bearings say it fades away. Here it
/// stands as long as those bearings that heard it hear it still (Konolige 1997, MURIEL).
///
/// A cone is the wider the further it reaches: from afar the two sides of a door answer as if it
/// were walled up. So what was heard from much nearer about counts instead of that.
class HeardWalls {
 public:
  explicit HeardWalls(double resolution) : resolution_(resolution) {}

  void clear() { tiles_.clear(); }
  /// `map_from_sensor`: where the sonar was; without an echo `range` is infinite.
  void add(const Pose2d& map_from_sensor, const SonarSpec& spec, double range);
  /// The robot stood there: nothing else does.
  void clearAround(double x, double y, double radius);
  bool isWall(double x, double y) const;

 private:
  static constexpr std::size_t kBearings = 16;
  static constexpr std::int64_t kTile = 32;  ///< cells along a side

  struct Cell {
    std::array<std::uint8_t, kBearings> echoes{};
    std::array<std::uint8_t, kBearings> passes{};
    std::array<std::uint8_t, kBearings> from{};  ///< how far off at the least [cells]; 0: not heard
  };
  using Tile = std::array<Cell, static_cast<std::size_t>(kTile* kTile)>;

  struct At {
    std::int64_t tile;
    std::size_t cell;
  };
  At at(double x, double y) const;
  Cell& cell(double x, double y);
  void count(double x, double y, std::size_t bin, double distance, bool is_echo);

  double resolution_;
  std::unordered_map<std::int64_t, Tile> tiles_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_HEARD_WALLS_H
