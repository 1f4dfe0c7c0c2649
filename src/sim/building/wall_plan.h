#ifndef PLACE_MEMORY_SIM_BUILDING_WALL_PLAN_H
#define PLACE_MEMORY_SIM_BUILDING_WALL_PLAN_H

#include <map>
#include <utility>
#include <vector>

#include "sim/world/vec2.h"
#include "sim/world/world.h"

namespace place_memory::sim {

/// An axis-aligned rectangle [m].
struct Rect {
  double x0 = 0.0;
  double y0 = 0.0;
  double x1 = 0.0;
  double y1 = 0.0;

  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  Vec2 center() const { return {0.5 * (x0 + x1), 0.5 * (y0 + y1)}; }
};

/// The stretch of wall that two rooms share; from == to where they share none.
struct SharedWall {
  Vec2 from;
  Vec2 to;
};

SharedWall sharedWall(const Rect& a, const Rect& b);

/// Walls of rooms that may touch: a stretch that two rooms share is built once, and openings are
/// left out.
class WallPlan {
 public:
  void addRoom(const Rect& room, const Material& material);

  /// Leaves out the axis-aligned stretch, whichever rooms it borders.
  void addOpening(Vec2 from, Vec2 to);

  std::vector<Wall> build() const;

 private:
  struct Stretch {
    double from;
    double to;
    Material material;
  };
  // Whether the line runs along x, and its other coordinate in millimetres.
  using Line = std::pair<bool, long>;

  static Line lineThrough(Vec2 from, Vec2 to);
  static std::vector<Stretch> without(const Stretch& stretch, double from, double to);
  void addStretch(Vec2 from, Vec2 to, const Material& material);

  std::map<Line, std::vector<Stretch>> lines_;
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_BUILDING_WALL_PLAN_H
