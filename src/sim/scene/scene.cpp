#include "sim/scene/scene.h"

#include <algorithm>

#include "sim/scene/scene_builder.h"

namespace place_memory::sim {

namespace {

constexpr double kCellSize = 0.5;  // [m]; about the size of the things in a room

// Distance along the ray to the segment, or a negative number.
double distanceAlongRay(const Ray& ray, const Segment& segment) {
  const Vec2 along = segment.direction;
  const double denominator = cross(ray.direction, along);
  if (std::fabs(denominator) < 1e-12) return -1.0;
  const Vec2 to_a = segment.a - ray.origin;
  const double on_segment = cross(to_a, ray.direction) / denominator;
  if (on_segment < 0.0 || on_segment > segment.length) return -1.0;
  return cross(to_a, along) / denominator;
}

}  // namespace

void testCircle(const Ray& ray, const Circle& circle, const RaySpread& spread, RayHit& hit,
                std::vector<NearCircle>* near) {
  const Vec2 to_center = circle.center - ray.origin;
  const double along = dot(to_center, ray.direction);
  const double surface = norm(to_center) - circle.radius;
  if (surface > hit.distance) return;
  if (along <= 0.0 && surface > 0.0) return;
  const double aside = std::fabs(cross(ray.direction, to_center));
  if (aside <= circle.radius) {
    const double half_chord = std::sqrt(circle.radius * circle.radius - aside * aside);
    const double distance = std::fmax(0.0, along - half_chord);
    if (distance < hit.distance) hit = {distance, nullptr, true};
  }
  if (near != nullptr && aside <= circle.radius + spread.offset + spread.slope * along) {
    near->push_back({std::fmax(0.0, surface), circle.strength});
  }
}

Scene::Scene(const World& world) : solids_(world.boxes) {
  SceneShapes shapes = buildShapes(world);
  segments_ = std::move(shapes.segments);
  circles_ = std::move(shapes.circles);
  measureBounds();
  fillGrid();
}

void Scene::measureBounds() {
  const double inf = std::numeric_limits<double>::infinity();
  Vec2 low{inf, inf};
  Vec2 high{-inf, -inf};
  const auto include = [&](Vec2 p, double margin) {
    low = {std::min(low.x, p.x - margin), std::min(low.y, p.y - margin)};
    high = {std::max(high.x, p.x + margin), std::max(high.y, p.y + margin)};
  };
  for (const Segment& segment : segments_) {
    include(segment.a, 0.1);
    include(segment.b, 0.1);
  }
  for (const Circle& circle : circles_) include(circle.center, circle.radius + kMaxSpread);
  if (segments_.empty() && circles_.empty()) include({0.0, 0.0}, 1.0);
  lower_ = low;
  upper_ = high;
}

void Scene::fillGrid() {
  std::vector<BucketGrid::Item> items;
  items.reserve(segments_.size() + circles_.size());
  for (const Segment& segment : segments_) items.push_back({segment.a, segment.b, 0.0});
  for (const Circle& circle : circles_) {
    items.push_back({circle.center, circle.center, circle.radius + kMaxSpread});
  }
  grid_ = BucketGrid(lower_, upper_, kCellSize, items);
}

RayHit Scene::cast(const Ray& ray, double max_distance, const RaySpread& spread,
                   std::vector<NearCircle>* near) const {
  RayHit hit{max_distance, nullptr, false};
  grid_.walkRay(
      ray.origin, ray.direction, [&] { return hit.distance; },
      [&](std::uint32_t id) {
        if (id >= segments_.size()) {
          testCircle(ray, circles_[id - segments_.size()], spread, hit, near);
          return;
        }
        const double distance = distanceAlongRay(ray, segments_[id]);
        if (distance > 0.0 && distance < hit.distance) hit = {distance, &segments_[id], true};
      });
  if (near != nullptr) {
    near->erase(
        std::remove_if(near->begin(), near->end(),
                       [&](const NearCircle& circle) { return circle.distance > hit.distance; }),
        near->end());
  }
  return hit;
}

bool Scene::isFree(Vec2 center, double radius) const {
  bool free = std::none_of(solids_.begin(), solids_.end(), [&](const Box& box) {
    const core::Pose2d local = box.pose.inverse() * core::Pose2d{center.x, center.y, 0.0};
    return std::fabs(local.x) <= 0.5 * box.width && std::fabs(local.y) <= 0.5 * box.depth;
  });
  grid_.visitSquare(center, radius, [&](std::uint32_t id) {
    if (!free) return;
    if (id < segments_.size()) {
      free = distanceToSegment(center, segments_[id].a, segments_[id].b) > radius;
    } else {
      const Circle& circle = circles_[id - segments_.size()];
      free = norm(center - circle.center) > radius + circle.radius;
    }
  });
  return free;
}

bool Scene::isPathFree(Vec2 from, Vec2 to, double radius) const {
  const double length = norm(to - from);
  const int steps = static_cast<int>(std::ceil(length / std::max(0.05, 0.5 * radius)));
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
    if (!isFree(from + (to - from) * t, radius)) return false;
  }
  return true;
}

}  // namespace place_memory::sim
