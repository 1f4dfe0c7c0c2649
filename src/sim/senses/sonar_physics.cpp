#include "sim/senses/sonar_physics.h"

#include <algorithm>
#include <limits>

namespace place_memory::sim {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kConcaveCorner = 0.8;  // sends a pulse back where it came from, like a cat's eye
constexpr double kEdge = 0.13;          // only diffracts
constexpr double kSkin = 1e-6;          // keeps a mirrored ray off the surface it left [m]

// A surface's echo grows weaker from the normal to its critical angle.
double surfaceGain(double incidence, double critical) {
  const double share = incidence / critical;
  return 1.0 - 0.7 * share * share;
}

// Two walls that face the viewer at about a right angle reflect twice and straight back.
bool isConcaveFrom(Vec2 to_viewer, Vec2 own, const SegmentEnd& end) {
  for (std::uint8_t i = 0; i < end.partner_count; ++i) {
    const Vec2 partner = end.partners[i];
    if (std::fabs(dot(own, partner)) > 0.5) continue;
    const double turn = cross(own, partner);
    if (cross(own, to_viewer) * turn > 0.0 && cross(to_viewer, partner) * turn > 0.0) return true;
  }
  return false;
}

class Ping {
 public:
  Ping(const Scene& scene, const std::vector<Circle>& people, const SonarPhysics& physics,
       double max_range)
      : scene_(scene), people_(people), physics_(physics), nearest_(max_range) {}

  void followSubray(Ray ray, double amplitude) {
    double path = 0.0;
    for (int bounce = 0; bounce <= physics_.max_bounces && isAudible(amplitude, path); ++bounce) {
      const RaySpread spread{0.6 * physics_.subray_spacing * path, 0.6 * physics_.subray_spacing};
      const RayHit hit = castAmongPeople(ray, nearest_ - path, spread);
      for (const NearCircle& circle : near_)
        hear(path + circle.distance, amplitude * circle.strength);
      if (hit.segment == nullptr) return;
      const Vec2 along = hit.segment->direction;
      const double cosine = std::min(1.0, std::fabs(cross(along, ray.direction)));
      hearEnds(ray, hit, path, amplitude, spread, cosine);
      const double incidence = std::acos(cosine);
      const double critical =
          std::min(hit.segment->material.critical_angle * physics_.roughness, 0.5 * core::kPi);
      if (incidence <= critical) {
        hear(path + hit.distance,
             amplitude * hit.segment->material.strength * surfaceGain(incidence, critical));
      }
      path += hit.distance;
      amplitude *= hit.segment->material.mirror;
      ray = mirrored(ray, hit.distance, along);
    }
  }

  bool heard() const { return heard_; }
  double range() const { return nearest_; }

 private:
  double loudness(double amplitude, double range) const {
    const double ratio = physics_.reach / std::max(range, 0.05);
    return amplitude * ratio * std::sqrt(ratio);
  }
  bool isAudible(double amplitude, double range) const { return loudness(amplitude, range) >= 1.0; }

  void hear(double range, double amplitude) {
    if (range >= nearest_ || !isAudible(amplitude, range)) return;
    nearest_ = range;
    heard_ = true;
  }

  RayHit castAmongPeople(const Ray& ray, double max_distance, const RaySpread& spread) {
    near_.clear();
    RayHit hit = scene_.cast(ray, max_distance, spread, &near_);
    for (const Circle& person : people_) testCircle(ray, person, spread, hit, &near_);
    return hit;
  }

  void hearEnds(const Ray& ray, const RayHit& hit, double path, double amplitude,
                const RaySpread& spread, double cosine) {
    const Segment& segment = *hit.segment;
    const Vec2 point = ray.origin + ray.direction * hit.distance;
    const double within = (spread.offset + spread.slope * hit.distance) / std::max(cosine, 0.1);
    const double from_a = dot(point - segment.a, segment.direction);
    if (from_a < within) {
      hearEnd(ray, segment.a, segment.direction, segment.ends[0], path, amplitude);
    }
    if (segment.length - from_a < within) {
      hearEnd(ray, segment.b, -segment.direction, segment.ends[1], path, amplitude);
    }
  }

  void hearEnd(const Ray& ray, Vec2 end, Vec2 own, const SegmentEnd& joint, double path,
               double amplitude) {
    const Vec2 to_viewer = ray.origin - end;
    const double range = path + norm(to_viewer);
    if (isConcaveFrom(to_viewer, own, joint)) {
      hear(range, amplitude * kConcaveCorner);
    } else if (!joint.continuous) {
      hear(range, amplitude * kEdge);
    }
  }

  static Ray mirrored(const Ray& ray, double distance, Vec2 along) {
    const Vec2 point = ray.origin + ray.direction * distance;
    const Vec2 direction = along * (2.0 * dot(along, ray.direction)) - ray.direction;
    return {point + direction * kSkin, direction};
  }

  const Scene& scene_;
  const std::vector<Circle>& people_;
  const SonarPhysics& physics_;
  double nearest_;
  bool heard_ = false;
  std::vector<NearCircle> near_;
};

}  // namespace

double clampToSpec(double range, const core::SonarSpec& spec) {
  if (range > spec.max_range) return kInfinity;
  if (range < spec.min_range) return -kInfinity;
  return range;
}

double pingSonar(const Scene& scene, const std::vector<Circle>& people, const core::Pose2d& sensor,
                 const core::SonarSpec& spec, const SonarPhysics& physics, Rng& rng) {
  // Every ping draws the same number of times, so that a change of the world leaves the noise
  // alone.
  const double threshold = std::exp(physics.threshold_noise * normal(rng));
  const double range_noise = normal(rng);
  const bool dropped = chance(rng, physics.drop_probability);
  const double half = 0.5 * spec.field_of_view;
  const double log_edge = std::log(physics.edge_gain);
  const int side = static_cast<int>(std::ceil(half / physics.subray_spacing));
  Ping ping(scene, people, physics, spec.max_range * 1.05);
  for (int i = 0; i <= 2 * side; ++i) {
    const int k = i % 2 == 0 ? i / 2 : -(i + 1) / 2;  // from the axis outwards: loud ones first
    const double offset = half * k / std::max(side, 1);
    const double gain = std::exp(log_edge * (offset / half) * (offset / half)) * threshold;
    ping.followSubray({{sensor.x, sensor.y}, unitVector(sensor.yaw + offset)}, gain);
  }
  if (!ping.heard() || dropped) return kInfinity;
  const double sigma = physics.absolute_noise + physics.relative_noise * ping.range();
  return clampToSpec(ping.range() * physics.range_scale + sigma * range_noise, spec);
}

}  // namespace place_memory::sim
