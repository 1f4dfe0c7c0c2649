#include "sim/scene/scene_builder.h"

#include <algorithm>
#include <utility>

#include "sim/scene/segment_joints.h"

namespace place_memory::sim {

namespace {

constexpr double kDoorInWall = 0.15;  // a door this near a wall's line is set into that wall [m]

struct Interval {
  double from;
  double to;
};

class ShapeCollector {
 public:
  explicit ShapeCollector(const World& world) : world_(world) {}

  SceneShapes collect() {
    for (const Wall& wall : world_.walls) addWall(wall);
    for (const Post& post : world_.posts)
      addCircle(post.center, post.radius, post.material.strength);
    for (const Box& box : world_.boxes) addBox(box);
    for (const Table& table : world_.tables) addTable(table);
    for (const Door& door : world_.doors) addDoor(door);
    for (const Chair& chair : world_.chairs) addChair(chair);
    for (const Bicycle& bicycle : world_.bicycles) addBicycle(bicycle);
    for (const Whiteboard& board : world_.whiteboards) {
      addSegment(board.from, board.to, standardMaterials().at("whiteboard"));
    }
    joinSegments(shapes_.segments);
    return std::move(shapes_);
  }

 private:
  void addSegment(Vec2 a, Vec2 b, const Material& material) {
    const double length = norm(b - a);
    if (length < 1e-3) return;
    shapes_.segments.push_back({a, b, material, (b - a) * (1.0 / length), length, {}});
  }

  void addCircle(Vec2 center, double radius, double strength) {
    shapes_.circles.push_back({center, radius, strength});
  }

  void addWall(const Wall& wall) {
    for (std::size_t i = 1; i < wall.points.size(); ++i) {
      const Vec2 a = wall.points[i - 1];
      const Vec2 b = wall.points[i];
      const double length = norm(b - a);
      const Vec2 along = (b - a) * (1.0 / length);
      double from = 0.0;
      for (const Interval& opening : openingsIn(a, along, length)) {
        if (opening.from > from)
          addSegment(a + along * from, a + along * opening.from, wall.material);
        from = std::max(from, opening.to);
      }
      if (from < length) addSegment(a + along * from, b, wall.material);
    }
  }

  std::vector<Interval> openingsIn(Vec2 a, Vec2 along, double length) const {
    std::vector<Interval> openings;
    for (const Door& door : world_.doors) {
      const Vec2 hinge = door.hinge - a;
      const Vec2 latch = door.latch - a;
      if (std::fabs(cross(along, hinge)) > kDoorInWall) continue;
      if (std::fabs(cross(along, latch)) > kDoorInWall) continue;
      const double from = std::min(dot(along, hinge), dot(along, latch));
      const double to = std::max(dot(along, hinge), dot(along, latch));
      if (to - from > 0.1 && to > 0.0 && from < length) openings.push_back({from, to});
    }
    std::sort(openings.begin(), openings.end(),
              [](const Interval& l, const Interval& r) { return l.from < r.from; });
    return openings;
  }

  void addBox(const Box& box) {
    const double x = 0.5 * box.width;
    const double y = 0.5 * box.depth;
    const Vec2 corners[] = {at(box.pose, {x, y}), at(box.pose, {-x, y}), at(box.pose, {-x, -y}),
                            at(box.pose, {x, -y})};
    for (std::size_t i = 0; i < 4; ++i) addSegment(corners[i], corners[(i + 1) % 4], box.material);
  }

  void addTable(const Table& table) {
    const double x = 0.5 * table.width - 0.05;
    const double y = 0.5 * table.depth - 0.05;
    for (const Vec2 leg : {Vec2{x, y}, Vec2{-x, y}, Vec2{-x, -y}, Vec2{x, -y}}) {
      addCircle(at(table.pose, leg), 0.03, 0.35);
    }
  }

  // The frame stands a little out of the wall; that is what tells a closed door from the wall.
  void addDoor(const Door& door) {
    addSegment(door.hinge, doorEdge(door), door.material);
    addCircle(door.hinge, 0.03, 0.35);
    addCircle(door.latch, 0.03, 0.35);
  }

  void addChair(const Chair& chair) {
    addCircle({chair.pose.x, chair.pose.y}, 0.2, 0.5);
    for (int foot = 0; foot < 5; ++foot) {
      addCircle(at(chair.pose, unitVector(foot * 0.4 * core::kPi) * 0.28), 0.025, 0.25);
    }
  }

  void addBicycle(const Bicycle& bicycle) {
    const Material tyre{1.2, 0.45, 0.2};
    addSegment(at(bicycle.pose, {-0.85, 0.0}), at(bicycle.pose, {-0.2, 0.0}), tyre);
    addSegment(at(bicycle.pose, {0.2, 0.0}), at(bicycle.pose, {0.85, 0.0}), tyre);
    addCircle({bicycle.pose.x, bicycle.pose.y}, 0.04, 0.4);
    addCircle(at(bicycle.pose, {0.45, 0.25}), 0.03, 0.3);
    addCircle(at(bicycle.pose, {0.45, -0.25}), 0.03, 0.3);
  }

  static Vec2 at(const core::Pose2d& pose, Vec2 local) {
    return Vec2{pose.x, pose.y} + rotated(local, pose.yaw);
  }

  const World& world_;
  SceneShapes shapes_;
};

}  // namespace

Vec2 doorEdge(const Door& door) {
  if (!door.open) return door.latch;
  return door.hinge + rotated(door.latch - door.hinge, door.swing);
}

SceneShapes buildShapes(const World& world) { return ShapeCollector(world).collect(); }

}  // namespace place_memory::sim
