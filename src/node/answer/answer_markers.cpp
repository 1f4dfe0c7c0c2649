#include "node/answer/answer_markers.h"

#include <geometry_msgs/Point.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "node/base/colors.h"

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;

constexpr double kDiameter = 1.0;           // [m]
constexpr double kHeight = 0.02;            // [m]
constexpr double kLevel = 0.035;            // above the regions of places, below the places [m]
constexpr double kLeastProbability = 0.02;  // less could not be seen
constexpr double kTextHeight = 0.45;        // [m]
constexpr double kTextLevel = 0.8;          // above the robot too [m]
constexpr double kTextBelow = 0.6;          // the label of the place [m]

Marker makeMarker(const std_msgs::Header& header, const std::string& name, int type) {
  Marker marker;
  marker.header = header;
  marker.header.stamp = ros::Time();  // rviz: drawn where the frame is, not where it was then
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::DELETE;
  marker.pose.orientation.w = 1.0;
  marker.color = toColor(kLikelyColor, 1.0F);
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const std::vector<LikelyPlace>& places,
                                          const std_msgs::Header& header) {
  Marker discs = makeMarker(header, "likely", Marker::SPHERE_LIST);
  discs.scale.x = discs.scale.y = kDiameter;
  discs.scale.z = kHeight;
  Marker percent = makeMarker(header, "probability", Marker::TEXT_VIEW_FACING);
  percent.scale.z = kTextHeight;
  for (const LikelyPlace& place : places) {
    if (!(place.probability >= kLeastProbability)) continue;
    geometry_msgs::Point& point = discs.points.emplace_back();
    point.x = place.map_from_place.x;
    point.y = place.map_from_place.y;
    point.z = kLevel;
    discs.colors.push_back(
        toColor(kLikelyColor, static_cast<float>(std::min(place.probability, 1.0))));
    if (percent.action == Marker::ADD) continue;
    percent.action = Marker::ADD;
    percent.pose.position = point;
    percent.pose.position.y -= kTextBelow;
    percent.pose.position.z = kTextLevel;
    percent.text = std::to_string(std::lround(100.0 * place.probability)) + " %";
  }
  // rviz reports a list without points as an error.
  if (!discs.points.empty()) discs.action = Marker::ADD;
  visualization_msgs::MarkerArray array;
  array.markers = {discs, percent};
  return array;
}

}  // namespace place_memory::node
