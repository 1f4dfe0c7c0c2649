#include "sim_node/world_markers.h"

#include <geometry_msgs/Point.h>

namespace place_memory::sim_node {
namespace {

using visualization_msgs::Marker;

constexpr double kLineWidth = 0.05;    // [m]
constexpr double kWorldLevel = 0.02;   // above the grids [m]
constexpr double kPersonHeight = 1.7;  // [m]

geometry_msgs::Point toPoint(sim::Vec2 position, double level) {
  geometry_msgs::Point point;
  point.x = position.x;
  point.y = position.y;
  point.z = level;
  return point;
}

Marker makeMarker(const std::string& frame, const std::string& name, int type) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.color.a = 1.0F;
  return marker;
}

void addOutline(const sim::Circle& circle, Marker& lines) {
  constexpr int kSides = 12;
  const auto corner = [&](int index) {
    const sim::Vec2 outwards = sim::unitVector(2.0 * core::kPi * index / kSides);
    return toPoint(circle.center + outwards * circle.radius, kWorldLevel);
  };
  for (int side = 0; side < kSides; ++side) {
    lines.points.push_back(corner(side));
    lines.points.push_back(corner(side + 1));
  }
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const sim::Scene& scene, const std::string& frame) {
  Marker lines = makeMarker(frame, "outline", Marker::LINE_LIST);
  lines.scale.x = kLineWidth;
  // As well to be seen on a dark background as on a bright one: 3.5 times as bright, and as dark.
  lines.color.r = 0.42F;
  lines.color.g = 0.45F;
  lines.color.b = 0.5F;
  for (const sim::Segment& segment : scene.segments()) {
    lines.points.push_back(toPoint(segment.a, kWorldLevel));
    lines.points.push_back(toPoint(segment.b, kWorldLevel));
  }
  for (const sim::Circle& circle : scene.circles()) addOutline(circle, lines);
  visualization_msgs::MarkerArray array;
  // rviz reports a line list without points as an error.
  if (lines.points.empty()) lines.action = Marker::DELETE;
  array.markers.push_back(lines);
  return array;
}

visualization_msgs::Marker toMarker(const std::vector<sim::Circle>& people,
                                    const std::string& frame) {
  Marker marker = makeMarker(frame, "people", Marker::SPHERE_LIST);
  marker.scale.x = marker.scale.y = 2.0 * (people.empty() ? 0.1 : people.front().radius);
  marker.scale.z = kPersonHeight;
  marker.color.r = 0.6F;
  marker.color.g = 0.5F;
  marker.color.b = 0.1F;
  for (const sim::Circle& person : people) {
    marker.points.push_back(toPoint(person.center, 0.5 * kPersonHeight));
  }
  if (people.empty()) marker.action = Marker::DELETE;
  return marker;
}

}  // namespace place_memory::sim_node
