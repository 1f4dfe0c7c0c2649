#include "sim/scene/segment_joints.h"

namespace place_memory::sim {

namespace {

constexpr double kTouching = 0.02;   // ends this near belong together [m]
constexpr double kStraight = 0.985;  // cosine above which two walls make one surface (10 degrees)

void addPartner(SegmentEnd& end, Vec2 own, Vec2 partner) {
  const double cosine = dot(own, partner);
  if (cosine < -kStraight) {
    end.continuous = true;
  } else if (cosine < kStraight && end.partner_count < end.partners.size()) {
    end.partners[end.partner_count++] = partner;
  }
}

// `own` points from the end `p` along its own segment.
void joinEnd(SegmentEnd& end, Vec2 p, Vec2 own, const Segment& other) {
  const Vec2 offset = p - other.a;
  const double along = dot(offset, other.direction);
  if (along < -kTouching || along > other.length + kTouching) return;
  if (std::fabs(cross(other.direction, offset)) > kTouching) return;
  if (along > kTouching) addPartner(end, own, -other.direction);
  if (along < other.length - kTouching) addPartner(end, own, other.direction);
}

}  // namespace

void joinSegments(std::vector<Segment>& segments) {
  for (Segment& segment : segments) {
    for (const Segment& other : segments) {
      if (&other == &segment) continue;
      joinEnd(segment.ends[0], segment.a, segment.direction, other);
      joinEnd(segment.ends[1], segment.b, -segment.direction, other);
    }
  }
}

}  // namespace place_memory::sim
