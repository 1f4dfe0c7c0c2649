#include "tools/map_picture.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "tools/svg.h"

namespace place_memory::tools {
namespace {

// Labels of more places would lie over each other; their hints remain.
constexpr std::size_t kMostLabels = 100;

/// What of the map a picture shows [m].
struct Extent {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = left;
  double top = right;

  void include(const core::Pose2d& at) {
    left = std::min(left, at.x);
    right = std::max(right, at.x);
    bottom = std::min(bottom, at.y);
    top = std::max(top, at.y);
  }
  double size() const { return std::max({right - left, top - bottom, 1.0}); }
};

using PlacesById = std::map<core::PlaceId, const core::Place*>;

std::string line(const core::Place& from, const core::Place& to, double width) {
  const core::Pose2d& a = from.map_from_place;
  const core::Pose2d& b = to.map_from_place;
  return "<line x1=\"" + decimal(a.x, 3) + "\" y1=\"" + decimal(-a.y, 3) + "\" x2=\"" +
         decimal(b.x, 3) + "\" y2=\"" + decimal(-b.y, 3) + "\" stroke=\"#888\" stroke-width=\"" +
         decimal(width, 4) + "\"/>";
}

std::string dot(const core::Place& place, double radius, bool with_label) {
  const core::Pose2d& at = place.map_from_place;
  const std::string words = place.label + " (" + decimal(at.x, 2) + ", " + decimal(at.y, 2) + ") m";
  std::string text = "<circle cx=\"" + decimal(at.x, 3) + "\" cy=\"" + decimal(-at.y, 3) +
                     "\" r=\"" + decimal(radius, 4) + "\" fill=\"#2060c0\">" + hint(words) +
                     "</circle>";
  if (!with_label) return text;
  return text + "<text x=\"" + decimal(at.x + 1.4 * radius, 3) + "\" y=\"" +
         decimal(-at.y - 0.6 * radius, 3) + "\" font-size=\"" + decimal(2.2 * radius, 4) + "\">" +
         escaped(place.label) + "</text>";
}

std::string sessionPicture(const PlacesById& places, const std::vector<core::PlaceLink>& links) {
  Extent extent;
  for (const auto& [id, place] : places) extent.include(place->map_from_place);
  const double radius = extent.size() / 90.0;
  const double left = extent.left - 4.0 * radius;
  const double bottom = extent.bottom - 4.0 * radius;
  const double width = extent.right - left + 20.0 * radius;  // labels stand to the right
  const double height = extent.top - bottom + 4.0 * radius;
  std::string text = "<svg class=\"map\" viewBox=\"" + decimal(left, 3) + " " +
                     decimal(-bottom - height, 3) + " " + decimal(width, 3) + " " +
                     decimal(height, 3) + "\">";
  for (const core::PlaceLink& link : links) {
    const auto first = places.find(link.first);
    const auto second = places.find(link.second);
    if (first == places.end() || second == places.end()) continue;
    text += line(*first->second, *second->second, radius / 3.0);
  }
  const bool with_labels = places.size() <= kMostLabels;
  for (const auto& [id, place] : places) text += dot(*place, radius, with_labels);
  return text + "</svg>\n";
}

}  // namespace

std::string mapPictures(const core::MapSnapshot& map) {
  std::map<core::SessionId, PlacesById> sessions;
  for (const core::Place& place : map.places) sessions[place.session][place.id] = &place;
  std::string text;
  for (const auto& [session, places] : sessions) {
    Extent extent;
    for (const auto& [id, place] : places) extent.include(place->map_from_place);
    text += "<h3>Session " + std::to_string(session) + ": " + std::to_string(places.size()) +
            (places.size() == 1 ? " place" : " places") + "</h3>\n<p>" +
            decimal(extent.right - extent.left, 1) + " m by " +
            decimal(extent.top - extent.bottom, 1) + " m</p>\n";
    text += sessionPicture(places, map.links);
  }
  return text;
}

}  // namespace place_memory::tools
