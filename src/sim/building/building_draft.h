#ifndef PLACE_MEMORY_SIM_BUILDING_BUILDING_DRAFT_H
#define PLACE_MEMORY_SIM_BUILDING_BUILDING_DRAFT_H

#include <string>
#include <vector>

#include "sim/building/wall_plan.h"
#include "sim/world/random.h"
#include "sim/world/world.h"

namespace place_memory::sim {

enum class RoomUse { kPassage, kOffice, kOpenPlan, kLaboratory, kHome, kArena };

struct Room {
  Rect rect;
  RoomUse use = RoomUse::kOffice;
};

/// The colours of one building, so to speak: its walls, doors and how full it is.
struct Style {
  Material wall;
  double wall_variety = 0.0;  ///< chance that a room's walls are of another kind
  double doors_open = 0.5;    ///< chance that a door stands open
  double clutter = 1.0;       ///< scales the amount of furniture
};

Style randomStyle(Rng& rng);

/// A building on the drawing board: rooms along the axes, what they contain, and what must stay
/// free.
class BuildingDraft {
 public:
  BuildingDraft(const Style& style, Rng& rng) : style_(style), rng_(rng) {}

  void addRoom(const Rect& rect, RoomUse use);

  /// A door in the stretch of wall, somewhere along it. False where the stretch is too short.
  bool addDoor(const SharedWall& wall);

  /// A gap without a door, somewhere along the stretch or as wide as it.
  bool addGap(const SharedWall& wall, bool whole);

  /// Joins all rooms that touch into one building by doors and gaps: a random spanning tree, and
  /// now and then another.
  void connectRooms(double gap_chance, double extra_chance);

  /// Whether a thing of this radius [m] stands clear of everything placed and of the doorways.
  bool hasRoom(Vec2 center, double radius) const;
  void occupy(Vec2 center, double radius) { occupied_.push_back({center, radius}); }

  std::string nextName(const std::string& stem) { return stem + "_" + std::to_string(names_++); }
  Material wallMaterial();

  World& world() { return world_; }
  Rng& rng() { return rng_; }
  const Style& style() const { return style_; }
  const std::vector<Room>& rooms() const { return rooms_; }

  /// The world with the walls built into it.
  World finish();

 private:
  struct Disc {
    Vec2 center;
    double radius;
  };

  Style style_;
  Rng& rng_;
  World world_;
  WallPlan walls_;
  std::vector<Room> rooms_;
  std::vector<Disc> occupied_;
  int names_ = 0;
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_BUILDING_BUILDING_DRAFT_H
