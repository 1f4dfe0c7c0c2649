#include "node/map/place_markers.h"

#include <geometry_msgs/Point.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "node/base/colors.h"
#include "node/map/nearest_places.h"

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;

constexpr double kRegionDiameter = 5.0 * 0.3048;  // [m]
constexpr double kRegionHeight = 0.02;
constexpr double kSpotDiameter = 0.4;
constexpr double kSpotLevel = 0.04;
constexpr double kLinkWidth = 0.06;
constexpr double kLabelHeight = 0.5;
constexpr double kLabelAbove = 0.5;  // the place, whose disc has its colour
constexpr double kLetterWidth = 0.6 * kLabelHeight;
constexpr std::size_t kCandidates = 10;  // for one label
// Above the grids, which rviz draws at the height of the frame, so that each stays visible.
constexpr double kLinkLevel = 0.03;
constexpr double kLabelLevel = 0.8;  // above the robot too
constexpr float kRegionAlpha = 0.12F;
constexpr float kSpotAlpha = 0.9F;
constexpr float kLinkAlpha = 0.9F;

// Blue for the first; neighbours in the row, and the first and the last, are easy to tell apart.
std_msgs::ColorRGBA sessionColor(core::SessionId session, float alpha) {
  constexpr std::array<Rgb, 6> kColors{{kPlaceColor,
                                        {0.9F, 0.45F, 0.1F},
                                        {0.2F, 0.65F, 0.3F},
                                        {0.75F, 0.25F, 0.7F},
                                        {0.7F, 0.6F, 0.1F},
                                        {0.8F, 0.2F, 0.25F}}};
  const auto number = static_cast<std::size_t>(std::max<core::SessionId>(session, 1) - 1);
  return toColor(kColors[number % kColors.size()], alpha);
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

geometry_msgs::Point makePoint(const core::Place& place, double level) {
  geometry_msgs::Point point;
  point.x = place.map_from_place.x;
  point.y = place.map_from_place.y;
  point.z = level;
  return point;
}

/// Flat discs.
Marker makeDiscs(const std_msgs::Header& header, const std::string& name, double diameter,
                 double level, float alpha, const std::vector<core::Place>& places) {
  Marker marker = makeMarker(header, name, Marker::SPHERE_LIST, 0);
  marker.scale.x = diameter;
  marker.scale.y = diameter;
  marker.scale.z = kRegionHeight;
  marker.color = sessionColor(1, alpha);
  for (const core::Place& place : places) {
    marker.points.push_back(makePoint(place, level));
    marker.colors.push_back(sessionColor(place.session, alpha));
  }
  return marker;
}

Marker makeLabel(const std_msgs::Header& header, const core::Place& place) {
  Marker marker = makeMarker(header, "labels", Marker::TEXT_VIEW_FACING, place.id);
  marker.pose.position = makePoint(place, kLabelLevel);
  marker.pose.position.y += kLabelAbove;
  marker.scale.z = kLabelHeight;
  marker.color = toColor(kPlaceColor, 1.0F);
  marker.text = place.label;
  return marker;
}

// Places are by rising id.
const core::Place* find(const std::vector<core::Place>& places, core::PlaceId id) {
  const auto at = std::lower_bound(
      places.begin(), places.end(), id,
      [](const core::Place& place, core::PlaceId wanted) { return place.id < wanted; });
  return at == places.end() || at->id != id ? nullptr : &*at;
}

Marker makeLinks(const std_msgs::Header& header, const core::MapSnapshot& map) {
  Marker marker = makeMarker(header, "links", Marker::LINE_LIST, 0);
  marker.scale.x = kLinkWidth;
  marker.color = sessionColor(1, kLinkAlpha);
  for (const core::PlaceLink& link : map.links) {
    for (const core::PlaceId id : {link.first, link.second}) {
      const core::Place& place = *find(map.places, id);
      marker.points.push_back(makePoint(place, kLinkLevel));
      marker.colors.push_back(sessionColor(place.session, kLinkAlpha));
    }
  }
  return marker;
}

/// Whether their texts would be drawn over each other, seen from above with north up.
bool overlap(const core::Place& a, const core::Place& b) {
  const double width = 0.5 * kLetterWidth * static_cast<double>(a.label.size() + b.label.size());
  const core::Pose2d& at = a.map_from_place;
  const core::Pose2d& other = b.map_from_place;
  return std::abs(at.x - other.x) < width && std::abs(at.y - other.y) < kLabelHeight;
}

/// Those nearest to `to` whose texts leave each other room, `count` at the most.
std::vector<const core::Place*> labelled(const std::vector<core::Place>& places,
                                         const core::Pose2d& to, std::size_t count) {
  const std::vector<const core::Place*> near = nearestPlaces(places, to, kCandidates * count);
  std::vector<const core::Place*> found;
  for (const core::Place* place : near) {
    if (found.size() == count) break;
    const auto covers = [&](const core::Place* other) { return overlap(*place, *other); };
    if (std::none_of(found.begin(), found.end(), covers)) found.push_back(place);
  }
  return found;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const core::MapSnapshot& map,
                                          const core::Pose2d& map_from_robot, std::size_t labels,
                                          const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  Marker& wipe = array.markers.emplace_back(makeMarker(header, "", Marker::CUBE, 0));
  wipe.action = Marker::DELETEALL;
  // rviz reports a list without points as an error.
  if (!map.places.empty()) {
    array.markers.push_back(
        makeDiscs(header, "regions", kRegionDiameter, 0.0, kRegionAlpha, map.places));
    array.markers.push_back(
        makeDiscs(header, "places", kSpotDiameter, kSpotLevel, kSpotAlpha, map.places));
  }
  for (const core::Place* place : labelled(map.places, map_from_robot, labels)) {
    array.markers.push_back(makeLabel(header, *place));
  }
  if (!map.links.empty()) array.markers.push_back(makeLinks(header, map));
  return array;
}

}  // namespace place_memory::node
