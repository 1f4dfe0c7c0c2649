#include "sim/building/building_plans.h"

#include <algorithm>
#include <cmath>

namespace place_memory::sim {

namespace {

/// One side of a passage: rooms are built from `start` along `along`, to the `outwards` side.
struct Side {
  Vec2 start;
  Vec2 along;
  Vec2 outwards;
  double length;
};

Rect spanning(Vec2 a, Vec2 b) {
  return {std::fmin(a.x, b.x), std::fmin(a.y, b.y), std::fmax(a.x, b.x), std::fmax(a.y, b.y)};
}

void addOffices(BuildingDraft& draft, const Side& side, const Rect& passage, double share) {
  Rng& rng = draft.rng();
  double at = uniform(rng, 0.0, 1.0);
  const double deepest = uniform(rng, 2.6, 5.0);
  while (side.length - at > 2.2) {
    const double width = std::min(uniform(rng, 2.2, 5.0), side.length - at);
    const double depth = chance(rng, 0.12) ? uniform(rng, 0.3, 1.5) : deepest;
    const Vec2 corner = side.start + side.along * at;
    at += width + (chance(rng, 0.2) ? uniform(rng, 0.2, 2.0) : 0.0);
    if (!chance(rng, share)) continue;
    const Rect office = spanning(corner, corner + side.along * width + side.outwards * depth);
    draft.addRoom(office, RoomUse::kOffice);
    const SharedWall wall = sharedWall(office, passage);
    if (depth < 2.0 || chance(rng, 0.1)) {
      draft.addGap(wall, true);
    } else {
      draft.addDoor(wall);
    }
  }
}

// Half columns, cabinets' edges and the like: what tells one piece of corridor from the next.
void addWallPosts(BuildingDraft& draft, const Rect& passage) {
  Rng& rng = draft.rng();
  const double spacing = uniform(rng, 2.5, 12.0);
  const double radius = uniform(rng, 0.06, 0.2);
  const bool level = passage.width() > passage.height();
  const double length = level ? passage.width() : passage.height();
  double next = uniform(rng, 0.5, spacing);
  while (next < length) {
    const double at = next;
    next += spacing * uniform(rng, 0.6, 1.4);
    const double across = chance(rng, 0.5) ? 0.0 : 1.0;
    const Vec2 center = level ? Vec2{passage.x0 + at, passage.y0 + across * passage.height()}
                              : Vec2{passage.x0 + across * passage.width(), passage.y0 + at};
    if (!draft.hasRoom(center, 0.0)) continue;
    draft.occupy(center, radius);
    draft.world().posts.push_back({center, radius, draft.wallMaterial()});
  }
}

void splitRooms(const Rect& rect, double smallest, Rng& rng, std::vector<Rect>& rooms) {
  const bool upright = rect.width() > rect.height();
  const double side = upright ? rect.width() : rect.height();
  const bool large = side > 2.0 * smallest + 0.4 && (side > 3.0 * smallest || chance(rng, 0.8));
  if (!large) {
    rooms.push_back(rect);
    return;
  }
  const double cut = uniform(rng, smallest, side - smallest);
  Rect first = rect;
  Rect second = rect;
  if (upright) {
    first.x1 = second.x0 = rect.x0 + cut;
  } else {
    first.y1 = second.y0 = rect.y0 + cut;
  }
  splitRooms(first, smallest, rng, rooms);
  splitRooms(second, smallest, rng, rooms);
}

void addInnerWall(BuildingDraft& draft, const Rect& arena) {
  Rng& rng = draft.rng();
  const double length = uniform(rng, 0.25, 0.45 * std::min(arena.width(), arena.height()));
  const double turn = chance(rng, 0.75) ? 0.5 * core::kPi * uniformInt(rng, 0, 3)
                                        : uniform(rng, 0.0, 2.0 * core::kPi);
  const Vec2 direction = unitVector(turn);
  Vec2 start{uniform(rng, arena.x0 + 0.2, arena.x1 - 0.2),
             uniform(rng, arena.y0 + 0.2, arena.y1 - 0.2)};
  if (chance(rng, 0.5)) {
    const auto side = uniformIndex(rng, 4);
    if (side == 0) start.x = arena.x0;
    if (side == 1) start.x = arena.x1;
    if (side == 2) start.y = arena.y0;
    if (side == 3) start.y = arena.y1;
  }
  const Vec2 raw = start + direction * length;
  const Vec2 end{std::min(std::max(raw.x, arena.x0), arena.x1),
                 std::min(std::max(raw.y, arena.y0), arena.y1)};
  if (norm(end - start) < 0.1) return;
  draft.world().walls.push_back({{start, end}, draft.wallMaterial()});
}

}  // namespace

void planCorridor(BuildingDraft& draft) {
  Rng& rng = draft.rng();
  const double length = uniform(rng, 12.0, 38.0);
  const double width = uniform(rng, 1.2, 2.6);
  const double share = uniform(rng, 0.5, 1.0);
  const Rect main{0.0, 0.0, length, width};
  draft.addRoom(main, RoomUse::kPassage);
  addOffices(draft, {{0.0, 0.0}, {1.0, 0.0}, {0.0, -1.0}, length}, main, share);
  const bool bent = chance(rng, 0.5);
  const double leg_width = uniform(rng, 1.2, 2.4);
  addOffices(draft, {{0.0, width}, {1.0, 0.0}, {0.0, 1.0}, length - (bent ? leg_width : 0.0)}, main,
             share);
  addWallPosts(draft, main);
  if (!bent) return;
  const Rect leg{length - leg_width, width, length, width + uniform(rng, 5.0, 15.0)};
  draft.addRoom(leg, RoomUse::kPassage);
  draft.addGap(sharedWall(main, leg), true);
  addOffices(draft, {{length, width}, {0.0, 1.0}, {1.0, 0.0}, leg.height()}, leg, share);
  if (leg.height() > 8.0) {
    addOffices(draft, {{leg.x0, width + 5.2}, {0.0, 1.0}, {-1.0, 0.0}, leg.height() - 5.2}, leg,
               share);
  }
  addWallPosts(draft, leg);
}

void planOpenPlan(BuildingDraft& draft) {
  Rng& rng = draft.rng();
  const Rect hall{0.0, 0.0, uniform(rng, 8.0, 22.0), uniform(rng, 6.0, 16.0)};
  draft.addRoom(hall, RoomUse::kOpenPlan);
  const Side sides[] = {{{0.0, 0.0}, {1.0, 0.0}, {0.0, -1.0}, hall.x1},
                        {{0.0, hall.y1}, {1.0, 0.0}, {0.0, 1.0}, hall.x1},
                        {{0.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, hall.y1},
                        {{hall.x1, 0.0}, {0.0, 1.0}, {1.0, 0.0}, hall.y1}};
  for (const Side& side : sides) {
    if (chance(rng, 0.65)) addOffices(draft, side, hall, uniform(rng, 0.4, 1.0));
  }
}

void planLaboratory(BuildingDraft& draft) {
  Rng& rng = draft.rng();
  const int count = uniformInt(rng, 2, 5);
  const double passage_width = uniform(rng, 1.4, 2.8);
  const double depth = uniform(rng, 4.5, 8.0);
  std::vector<Rect> rooms;
  double at = 0.0;
  for (int i = 0; i < count; ++i) {
    const double width = uniform(rng, 3.5, 9.0);
    rooms.push_back(
        {at, passage_width, at + width, passage_width + depth * uniform(rng, 0.8, 1.0)});
    at += width;
  }
  const Rect passage{0.0, 0.0, at, passage_width};
  draft.addRoom(passage, RoomUse::kPassage);
  for (const Rect& room : rooms) draft.addRoom(room, RoomUse::kLaboratory);
  draft.connectRooms(uniform(rng, 0.0, 0.6), 0.3);
  if (chance(rng, 0.5)) {
    addOffices(draft, {{0.0, 0.0}, {1.0, 0.0}, {0.0, -1.0}, at}, passage, 0.7);
  }
  addWallPosts(draft, passage);
}

void planHome(BuildingDraft& draft) {
  Rng& rng = draft.rng();
  std::vector<Rect> rooms;
  splitRooms({0.0, 0.0, uniform(rng, 6.0, 14.0), uniform(rng, 5.0, 11.0)}, uniform(rng, 1.8, 2.8),
             rng, rooms);
  for (const Rect& room : rooms) draft.addRoom(room, RoomUse::kHome);
  draft.connectRooms(uniform(rng, 0.1, 0.6), 0.2);
}

void planArena(BuildingDraft& draft) {
  Rng& rng = draft.rng();
  const Rect arena{0.0, 0.0, uniform(rng, 1.8, 4.2), uniform(rng, 1.8, 4.2)};
  draft.addRoom(arena, RoomUse::kArena);
  const int walls = uniformInt(rng, 1, 5);
  for (int i = 0; i < walls; ++i) addInnerWall(draft, arena);
  const int bins = uniformInt(rng, 0, 2);
  for (int i = 0; i < bins; ++i) {
    draft.world().posts.push_back({{uniform(rng, 0.0, arena.x1), uniform(rng, 0.0, arena.y1)},
                                   uniform(rng, 0.03, 0.15),
                                   draft.wallMaterial()});
  }
}

}  // namespace place_memory::sim
