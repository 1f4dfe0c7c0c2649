#ifndef PLACE_MEMORY_SIM_SCENE_SCENE_H
#define PLACE_MEMORY_SIM_SCENE_SCENE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/scene/bucket_grid.h"
#include "sim/world/material.h"
#include "sim/world/vec2.h"
#include "sim/world/world.h"

namespace place_memory::sim {

/// What joins a segment at one of its ends; decides what the end echoes.
struct SegmentEnd {
  std::array<Vec2, 2> partners;    ///< directions, from the end, of what joins there
  std::uint8_t partner_count = 0;  ///< 0: a free edge
  bool continuous = false;         ///< the surface runs straight on: no echo of its own
};

struct Segment {
  Vec2 a;
  Vec2 b;
  Material material;
  Vec2 direction;       ///< unit, from a to b
  double length = 0.0;  ///< [m], > 0
  std::array<SegmentEnd, 2> ends;
};

/// Leg, post, person. Echoes from its nearest point whatever the bearing.
struct Circle {
  Vec2 center;
  double radius = 0.1;    ///< [m]
  double strength = 0.5;  ///< echo amplitude, (0, 1]; small things scatter little
};

struct Ray {
  Vec2 origin;
  Vec2 direction;  ///< unit
};

/// What stops a ray first.
struct RayHit {
  double distance = 0.0;             ///< [m]; the asked maximum where nothing was hit
  const Segment* segment = nullptr;  ///< null where a circle or nothing was hit
  bool blocked = false;
};

/// A circle that the ray hits or passes within its spread.
struct NearCircle {
  double distance = 0.0;  ///< from the ray's origin to the circle's nearest point [m]
  double strength = 0.0;
};

/// How far a ray speaks for its surroundings: `offset + slope * distance` to each side [m].
struct RaySpread {
  double offset = 0.0;
  double slope = 0.0;
};

/// The surfaces of a world, flattened and indexed for ray casting. Constant once built, so any
/// number of threads may share it; build a new one after a change of the world.
class Scene {
 public:
  explicit Scene(const World& world);

  /// The first thing along the ray within `max_distance`. Circles within the spread (at most
  /// kMaxSpread) and nearer than the hit are appended to `near` unless it is null.
  RayHit cast(const Ray& ray, double max_distance, const RaySpread& spread,
              std::vector<NearCircle>* near) const;

  /// Whether a disc of `radius` [m] at `center` touches nothing. Outside the bounds nothing is
  /// there.
  bool isFree(Vec2 center, double radius) const;

  /// Whether such a disc can be moved from `from` to `to` in a straight line.
  bool isPathFree(Vec2 from, Vec2 to, double radius) const;

  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Circle>& circles() const { return circles_; }
  Vec2 lowerBound() const { return lower_; }
  Vec2 upperBound() const { return upper_; }

  static constexpr double kMaxSpread = 0.25;  ///< [m]

 private:
  void measureBounds();
  void fillGrid();

  std::vector<Segment> segments_;
  std::vector<Circle> circles_;
  std::vector<Box> solids_;  // nothing can stand inside these, though their surface is far
  Vec2 lower_;
  Vec2 upper_;
  BucketGrid grid_;
};

/// Shrinks `hit` to `circle` where the ray meets it sooner, and notes it in `near` (if given) where
/// it lies within the spread. People, who are no part of a scene, are tested with it too.
void testCircle(const Ray& ray, const Circle& circle, const RaySpread& spread, RayHit& hit,
                std::vector<NearCircle>* near);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_SCENE_SCENE_H
