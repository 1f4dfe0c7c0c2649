#include "node/map/place_markers.h"

#include <geometry_msgs/Point.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <string>

#include "node/conversions.h"

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;

constexpr double kRegionDiameter = 5.0 * 0.3048;  // [m]
constexpr double kRegionHeight = 0.02;
constexpr double kLinkWidth = 0.06;
constexpr double kLabelHeight = 0.5;
// Above the grids, which rviz draws at the height of the frame, so that each stays visible.
constexpr double kLinkLevel = 0.03;
constexpr double kLabelLevel = 0.4;

std_msgs::ColorRGBA color(float red, float green, float blue, float alpha) {
  std_msgs::ColorRGBA color;
  color.r = red;
  color.g = green;
  color.b = blue;
  color.a = alpha;
  return color;
}

Marker makeMarker(const std_msgs::Header& header, const std::string& name, int type,
                  core::PlaceId id) {
  Marker marker;
  marker.header = header;
  marker.header.stamp = ros::Time();  // rviz: drawn where the frame is, not where it was then
  marker.ns = name;
  marker.id = static_cast<int>(id);
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker makeRegion(const std_msgs::Header& header, const core::Place& place) {
  Marker marker = makeMarker(header, "regions", Marker::CYLINDER, place.id);
  marker.pose.position.x = place.map_from_place.x;
  marker.pose.position.y = place.map_from_place.y;
  marker.scale.x = kRegionDiameter;
  marker.scale.y = kRegionDiameter;
  marker.scale.z = kRegionHeight;
  marker.color = color(0.2F, 0.5F, 0.9F, 0.35F);
  return marker;
}

Marker makeLabel(const std_msgs::Header& header, const core::Place& place) {
  Marker marker = makeMarker(header, "labels", Marker::TEXT_VIEW_FACING, place.id);
  marker.pose.position.x = place.map_from_place.x;
  marker.pose.position.y = place.map_from_place.y;
  marker.pose.position.z = kLabelLevel;
  marker.scale.z = kLabelHeight;
  marker.color = color(0.05F, 0.1F, 0.4F, 1.0F);
  marker.text = place.label;
  return marker;
}

geometry_msgs::Point makePoint(const core::Place& place) {
  geometry_msgs::Point point;
  point.x = place.map_from_place.x;
  point.y = place.map_from_place.y;
  point.z = kLinkLevel;
  return point;
}

const core::Place& find(const core::MapSnapshot& map, core::PlaceId id) {
  return *std::lower_bound(
      map.places.begin(), map.places.end(), id,
      [](const core::Place& place, core::PlaceId key) { return place.id < key; });
}

Marker makeLinks(const std_msgs::Header& header, const core::MapSnapshot& map) {
  Marker marker = makeMarker(header, "links", Marker::LINE_LIST, 0);
  marker.scale.x = kLinkWidth;
  marker.color = color(0.1F, 0.3F, 0.7F, 0.9F);
  for (const core::PlaceLink& link : map.links) {
    marker.points.push_back(makePoint(find(map, link.first)));
    marker.points.push_back(makePoint(find(map, link.second)));
  }
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const core::MapSnapshot& map,
                                          const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  Marker& wipe = array.markers.emplace_back(makeMarker(header, "", Marker::CUBE, 0));
  wipe.action = Marker::DELETEALL;
  for (const core::Place& place : map.places) {
    array.markers.push_back(makeRegion(header, place));
    array.markers.push_back(makeLabel(header, place));
  }
  // rviz reports a line list without points as an error.
  if (!map.links.empty()) array.markers.push_back(makeLinks(header, map));
  return array;
}

}  // namespace place_memory::node
