#ifndef PLACE_MEMORY_SIM_WORLD_VEC2_H
#define PLACE_MEMORY_SIM_WORLD_VEC2_H

#include <cmath>

namespace place_memory::sim {

/// A point or a direction in the plane of the world [m].
struct Vec2 {
  double x = 0.0;
  double y = 0.0;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
inline Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }

inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }

/// Positive where b lies counter-clockwise of a.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }
inline Vec2 leftOf(Vec2 a) { return {-a.y, a.x}; }
inline Vec2 unitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline Vec2 rotated(Vec2 a, double angle) {
  const Vec2 u = unitVector(angle);
  return {u.x * a.x - u.y * a.y, u.y * a.x + u.x * a.y};
}

/// Distance from `p` to the nearest point of the segment from `a` to `b` (which may coincide).
inline double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  if (squared <= 0.0) return norm(p - a);
  const double t = std::fmin(1.0, std::fmax(0.0, dot(p - a, along) / squared));
  return norm(p - a - along * t);
}

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_WORLD_VEC2_H
