#include "node/drive/belief_markers.h"

#include <cmath>
#include <string>

namespace place_memory::node {
namespace {

constexpr double kShown = 0.01;      // least probability of a disc
constexpr double kDiameter = 1.5;    // of a certain one [m]
constexpr double kThickness = 0.02;  // [m]
constexpr double kText = 0.25;       // height of a letter [m]
constexpr double kTextUp = 0.6;      // over the floor [m]

std::string percent(double probability) {
  return std::to_string(std::lround(100.0 * probability)) + " %";
}

visualization_msgs::Marker marker(const PlaceBelief& belief, int id, int type) {
  visualization_msgs::Marker marker;
  marker.header = belief.header;
  marker.header.stamp = ros::Time();  // rviz: drawn where the frame is, not where it was then
  marker.ns = "belief";
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.color.a = 1.0F;
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const PlaceBelief& belief,
                                          const std::vector<geometry_msgs::Pose2D>& locations) {
  using visualization_msgs::Marker;
  visualization_msgs::MarkerArray markers;
  markers.markers.push_back(marker(belief, 0, Marker::CUBE));
  markers.markers.back().action = Marker::DELETEALL;
  for (std::size_t i = 0; i < belief.ids.size(); ++i) {
    if (belief.probabilities[i] < kShown) continue;
    Marker disc = marker(belief, static_cast<int>(i) + 1, Marker::CYLINDER);
    disc.pose.position.x = locations[i].x;
    disc.pose.position.y = locations[i].y;
    disc.scale.x = disc.scale.y = kDiameter * std::sqrt(belief.probabilities[i]);
    disc.scale.z = kThickness;
    disc.color.r = 0.9F;
    disc.color.g = 0.3F;
    disc.color.b = 0.1F;
    disc.color.a = 0.5F;
    markers.markers.push_back(disc);
  }
  if (belief.ids.empty()) return markers;
  Marker text = marker(belief, 0, Marker::TEXT_VIEW_FACING);
  text.pose.position.x = locations.front().x;
  text.pose.position.y = locations.front().y;
  text.pose.position.z = kTextUp;
  text.scale.z = kText;
  text.text = "lost " + percent(belief.p_lost) + ", off the map " + percent(belief.off_map);
  markers.markers.push_back(text);
  return markers;
}

}  // namespace place_memory::node
