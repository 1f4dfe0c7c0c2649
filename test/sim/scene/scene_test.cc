#include "sim/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/building/building_generator.h"
#include "sim/world/random.h"

namespace place_memory::sim {
namespace {

// Every shape tested in turn, and the intersection worked out from the line equation instead.
double naiveCast(const Scene& scene, const Ray& ray, double nearest) {
  for (const Segment& segment : scene.segments()) {
    const double side_a = cross(ray.direction, segment.a - ray.origin);
    const double side_b = cross(ray.direction, segment.b - ray.origin);
    if (side_a * side_b > 0.0 || side_a == side_b) continue;
    const Vec2 point = segment.a + (segment.b - segment.a) * (side_a / (side_a - side_b));
    const double distance = dot(point - ray.origin, ray.direction);
    if (distance > 0.0) nearest = std::fmin(nearest, distance);
  }
  for (const Circle& circle : scene.circles()) {
    const Vec2 center = circle.center - ray.origin;
    const double b = dot(center, ray.direction);
    const double square = b * b - dot(center, center) + circle.radius * circle.radius;
    if (square < 0.0 || b + std::sqrt(square) < 0.0) continue;
    nearest = std::fmin(nearest, std::fmax(0.0, b - std::sqrt(square)));
  }
  return nearest;
}

bool naiveIsFree(const Scene& scene, Vec2 at, double radius) {
  for (const Segment& segment : scene.segments()) {
    if (distanceToSegment(at, segment.a, segment.b) <= radius) return false;
  }
  for (const Circle& circle : scene.circles()) {
    if (norm(at - circle.center) <= radius + circle.radius) return false;
  }
  return true;
}

class SceneOfBuilding : public testing::TestWithParam<int> {
 protected:
  SceneOfBuilding()
      : world_(generateBuilding(static_cast<BuildingKind>(GetParam()), 5)), scene_(world_) {}

  Vec2 anywhere(Rng& rng) const {
    const Vec2 margin{2.0, 2.0};
    const Vec2 low = scene_.lowerBound() - margin;
    const Vec2 high = scene_.upperBound() + margin;
    return {uniform(rng, low.x, high.x), uniform(rng, low.y, high.y)};
  }

  World world_;
  Scene scene_;
};

TEST_P(SceneOfBuilding, CastsAsFarAsTheNaiveSearch) {
  Rng rng(1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{anywhere(rng), unitVector(uniform(rng, 0.0, 2.0 * core::kPi))};
    const double expected = naiveCast(scene_, ray, 6.0);
    const RayHit hit = scene_.cast(ray, 6.0, {}, nullptr);
    ASSERT_NEAR(hit.distance, expected, 1e-6) << "ray " << i;
    ASSERT_EQ(hit.blocked, expected < 6.0);
    hits += hit.blocked ? 1 : 0;
  }
  EXPECT_GT(hits, 200);
}

TEST_P(SceneOfBuilding, CastsAlongTheAxes) {
  Rng rng(2);
  for (int i = 0; i < 400; ++i) {
    const Vec2 axes[] = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};
    const Ray ray{anywhere(rng), axes[i % 4]};
    ASSERT_NEAR(scene_.cast(ray, 50.0, {}, nullptr).distance, naiveCast(scene_, ray, 50.0), 1e-6);
  }
}

TEST_P(SceneOfBuilding, NotesEveryCircleWithinTheSpread) {
  Rng rng(3);
  const RaySpread spread{0.02, 0.03};
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{anywhere(rng), unitVector(uniform(rng, 0.0, 2.0 * core::kPi))};
    std::vector<NearCircle> near;
    const RayHit hit = scene_.cast(ray, 5.0, spread, &near);
    for (const Circle& circle : scene_.circles()) {
      const Vec2 to_center = circle.center - ray.origin;
      const double along = dot(to_center, ray.direction);
      const double surface = norm(to_center) - circle.radius;
      const double within = circle.radius + spread.offset + spread.slope * along;
      if (along <= 0.0 || surface <= 0.0 || surface > hit.distance - 1e-6) continue;
      if (std::fabs(cross(ray.direction, to_center)) > within - 1e-6) continue;
      EXPECT_TRUE(std::any_of(
          near.begin(), near.end(),
          [&](const NearCircle& noted) { return std::fabs(noted.distance - surface) < 1e-9; }))
          << "ray " << i;
    }
  }
}

TEST_P(SceneOfBuilding, KnowsWhatIsFree) {
  Rng rng(4);
  int boxed = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 at = anywhere(rng);
    const double radius = uniform(rng, 0.01, 0.8);
    const bool inside_a_box = naiveIsFree(scene_, at, radius) && !scene_.isFree(at, radius);
    EXPECT_TRUE(inside_a_box || scene_.isFree(at, radius) == naiveIsFree(scene_, at, radius));
    boxed += inside_a_box ? 1 : 0;
  }
  EXPECT_LT(boxed, 200);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SceneOfBuilding, testing::Range(0, kBuildingKinds));

TEST(Scene, InsideABoxIsNotFree) {
  World world;
  world.boxes.push_back({{3.0, 2.0, 0.4}, 4.0, 3.0, {}});
  EXPECT_FALSE(Scene(world).isFree({3.0, 2.0}, 0.1));
  EXPECT_TRUE(Scene(world).isFree({6.0, 2.0}, 0.1));
}

TEST(Scene, AnEmptyWorldStopsNothing) {
  const Scene scene{World{}};
  EXPECT_FALSE(scene.cast({{0.0, 0.0}, {1.0, 0.0}}, 5.0, {}, nullptr).blocked);
  EXPECT_TRUE(scene.isFree({0.0, 0.0}, 1.0));
}

TEST(Scene, ADoorCutsItsOpeningIntoTheWall) {
  World world;
  world.walls.push_back({{{0.0, 0.0}, {10.0, 0.0}}, {}});
  world.doors.push_back({"door", {4.0, 0.05}, {5.0, 0.05}, 1.5, false, {}});
  const Ray through{{4.5, -2.0}, {0.0, 1.0}};
  const RayHit closed = Scene(world).cast(through, 9.0, {}, nullptr);
  EXPECT_NEAR(closed.distance, 2.05, 1e-9);
  world.doors[0].open = true;
  EXPECT_FALSE(Scene(world).cast(through, 9.0, {}, nullptr).blocked);
  EXPECT_TRUE(Scene(world).isPathFree({4.5, -1.0}, {4.5, 1.0}, 0.3));
  EXPECT_FALSE(Scene(world).isPathFree({3.5, -1.0}, {3.5, 1.0}, 0.3));
}

}  // namespace
}  // namespace place_memory::sim
