#include "sim/building/furnisher.h"

#include <algorithm>
#include <cmath>

namespace place_memory::sim {

namespace {

constexpr int kAttempts = 12;

/// Pieces per square metre of floor, or per metre of wall for what stands along walls.
struct Furnishing {
  double along_walls;
  double islands;
  double tables;
  double chairs;
  double posts;
  double boards;
  double deepest;  // of what stands along walls [m]
};

Furnishing furnishingFor(RoomUse use) {
  switch (use) {
    case RoomUse::kPassage:
      return {0.10, 0.0, 0.0, 0.0, 0.0, 0.02, 0.15};
    case RoomUse::kOffice:
      return {0.30, 0.02, 0.02, 0.12, 0.01, 0.05, 0.8};
    case RoomUse::kOpenPlan:
      return {0.15, 0.12, 0.03, 0.10, 0.02, 0.03, 0.7};
    case RoomUse::kLaboratory:
      return {0.25, 0.07, 0.03, 0.06, 0.02, 0.04, 0.9};
    case RoomUse::kHome:
      return {0.30, 0.03, 0.05, 0.08, 0.01, 0.01, 1.0};
    case RoomUse::kArena:
      return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1};
  }
  return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1};
}

class Furnisher {
 public:
  Furnisher(BuildingDraft& draft, const Room& room)
      : draft_(draft), rng_(draft.rng()), rect_(room.rect), plan_(furnishingFor(room.use)) {}

  void furnish() {
    const double area = rect_.width() * rect_.height();
    const double border = 2.0 * (rect_.width() + rect_.height());
    repeat(plan_.boards * border, [&] { return addBoard(); });
    repeat(plan_.along_walls * border, [&] { return addAlongWall(); });
    repeat(plan_.posts * area, [&] { return addPost(); });
    repeat(plan_.islands * area, [&] { return addIsland(); });
    repeat(plan_.tables * area, [&] { return addTable(); });
    repeat(plan_.chairs * area, [&] { return addChair(); });
  }

 private:
  template <typename Add>
  void repeat(double expected, Add add) {
    const double wanted = expected * draft_.style().clutter * uniform(rng_, 0.4, 1.6);
    for (int i = 0; i < static_cast<int>(std::round(wanted)); ++i) {
      for (int attempt = 0; attempt < kAttempts && !add(); ++attempt) continue;
    }
  }

  Vec2 anywhere(double margin) {
    return {uniform(rng_, rect_.x0 + margin, std::max(rect_.x0 + margin, rect_.x1 - margin)),
            uniform(rng_, rect_.y0 + margin, std::max(rect_.y0 + margin, rect_.y1 - margin))};
  }

  // A frame on one of the walls: x along it, y into the room.
  core::Pose2d onWall(double half_length) {
    const auto side = uniformIndex(rng_, 4);
    const bool level = side < 2;
    const double low = (level ? rect_.x0 : rect_.y0) + half_length;
    const double high = (level ? rect_.x1 : rect_.y1) - half_length;
    const double at = uniform(rng_, low, std::max(low, high));
    if (side == 0) return {at, rect_.y0, 0.0};
    if (side == 1) return {at, rect_.y1, core::kPi};
    if (side == 2) return {rect_.x0, at, -0.5 * core::kPi};
    return {rect_.x1, at, 0.5 * core::kPi};
  }

  bool fits(double length) const { return length < std::min(rect_.width(), rect_.height()) - 0.2; }

  bool addBoard() {
    const double length = uniform(rng_, 0.8, 2.4);
    if (!fits(length)) return false;
    const core::Pose2d wall = onWall(0.5 * length);
    if (!draft_.hasRoom({wall.x, wall.y}, 0.5 * length)) return false;
    const core::Pose2d from = wall * core::Pose2d{-0.5 * length, 0.03, 0.0};
    const core::Pose2d to = wall * core::Pose2d{0.5 * length, 0.03, 0.0};
    draft_.world().whiteboards.push_back(
        {draft_.nextName("board"), {from.x, from.y}, {to.x, to.y}});
    draft_.occupy({wall.x, wall.y}, 0.4 * length);
    return true;
  }

  bool addAlongWall() {
    const double length = uniform(rng_, 0.3, 2.0);
    const double depth = uniform(rng_, 0.5, 1.0) * plan_.deepest;
    if (!fits(length)) return false;
    const core::Pose2d wall = onWall(0.5 * length);
    const core::Pose2d pose = wall * core::Pose2d{0.0, 0.5 * depth + uniform(rng_, 0.0, 0.05), 0.0};
    return addBox(pose, length, depth);
  }

  bool addIsland() {
    const bool partition = chance(rng_, 0.3);
    const double length = uniform(rng_, 0.4, 2.2);
    const double depth = partition ? 0.08 : uniform(rng_, 0.3, 0.9);
    if (!fits(length + 1.0)) return false;
    const double turn = chance(rng_, 0.7) ? 0.0 : uniform(rng_, -0.8, 0.8);
    const Vec2 at = anywhere(0.5 * length + 0.3);
    return addBox({at.x, at.y, turn + (chance(rng_, 0.5) ? 0.5 * core::kPi : 0.0)}, length, depth);
  }

  bool addBox(const core::Pose2d& pose, double length, double depth) {
    const int discs = static_cast<int>(length / depth) + 1;
    const double radius = 0.5 * std::hypot(length / discs, depth);
    const auto center = [&](int i) {
      const core::Pose2d at =
          pose * core::Pose2d{(i + 0.5 - 0.5 * discs) * length / discs, 0.0, 0.0};
      return Vec2{at.x, at.y};
    };
    for (int i = 0; i < discs; ++i) {
      if (!draft_.hasRoom(center(i), radius)) return false;
    }
    for (int i = 0; i < discs; ++i) draft_.occupy(center(i), radius);
    const char* kinds[] = {"furniture", "furniture", "wood", "metal", "cloth", "painted"};
    draft_.world().boxes.push_back(
        {pose, length, depth, standardMaterials().at(kinds[uniformIndex(rng_, 6)])});
    return true;
  }

  bool addPost() {
    const double radius = uniform(rng_, 0.04, 0.3);
    const Vec2 at = anywhere(radius);
    if (!draft_.hasRoom(at, radius)) return false;
    draft_.occupy(at, radius);
    draft_.world().posts.push_back({at, radius, draft_.wallMaterial()});
    return true;
  }

  bool addTable() {
    const double width = uniform(rng_, 0.6, 1.8);
    const double depth = uniform(rng_, 0.5, 0.9);
    const double radius = 0.5 * std::hypot(width, depth);
    const Vec2 at = anywhere(radius);
    if (!fits(2.0 * radius) || !draft_.hasRoom(at, radius)) return false;
    draft_.occupy(at, radius);
    draft_.world().tables.push_back({{at.x, at.y, uniform(rng_, -0.2, 0.2)}, width, depth});
    return true;
  }

  bool addChair() {
    const Vec2 at = anywhere(0.35);
    if (!draft_.hasRoom(at, 0.32)) return false;
    draft_.occupy(at, 0.32);
    draft_.world().chairs.push_back(
        {draft_.nextName("chair"), {at.x, at.y, uniform(rng_, -core::kPi, core::kPi)}});
    return true;
  }

  BuildingDraft& draft_;
  Rng& rng_;
  const Rect& rect_;
  Furnishing plan_;
};

}  // namespace

void furnish(BuildingDraft& draft, const Room& room) { Furnisher(draft, room).furnish(); }

}  // namespace place_memory::sim
