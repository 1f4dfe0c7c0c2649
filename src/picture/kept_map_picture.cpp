#include "picture/kept_map_picture.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/sensing/moved_readings.h"

namespace place_memory::picture {
namespace {

constexpr int kPixels = 1400;   // along the longer side
constexpr int kMapSession = 1;  // in whose frame a mapper's map lies

/// At which place each scan was: the one that it is, or the nearest one that it was known as.
std::vector<core::PlaceId> placesOfScans(const core::KeptMap& map) {
  std::vector<core::PlaceId> places;
  for (const core::ScanNode& node : map.nodes) places.push_back(node.place);
  std::vector<double> nearest(map.nodes.size(), std::numeric_limits<double>::infinity());
  for (const core::Tie& tie : map.ties) {
    const double distance = std::hypot(tie.relative.x, tie.relative.y);
    if (map.nodes[tie.node].place != core::kNoPlace || distance >= nearest[tie.node]) continue;
    nearest[tie.node] = distance;
    places[tie.node] = map.nodes[tie.place].place;
  }
  return places;
}

/// Between places that the robot went to one after the other.
std::vector<core::PlaceLink> linksOf(const core::KeptMap& map) {
  const std::vector<core::PlaceId> places = placesOfScans(map);
  std::set<std::pair<core::PlaceId, core::PlaceId>> pairs;
  for (core::NodeIndex at = 0; at < map.nodes.size(); ++at) {
    if (places[at] == core::kNoPlace) continue;
    std::optional<core::NodeIndex> before = map.nodes[at].before;
    while (before && places[*before] == core::kNoPlace) before = map.nodes[*before].before;
    if (before && places[*before] != places[at])
      pairs.insert(std::minmax(places[*before], places[at]));
  }
  std::vector<core::PlaceLink> links;
  for (const auto& [first, second] : pairs) {
    core::PlaceLink& link = links.emplace_back();
    link.first = first;
    link.second = second;
  }
  return links;
}

}  // namespace

DrawnMap drawnMap(const core::KeptMap& map, const MapMaking& making,
                  const std::function<std::string(core::PlaceId)>& label_of) {
  const core::SonarModel sonar(making.sonar);
  core::FusedMap fused(making.fused, making.grid);
  DrawnMap drawn;
  for (const core::ScanNode& node : map.nodes) {
    if (node.place == core::kNoPlace || node.session != kMapSession) continue;
    core::Place place;
    place.id = node.place;
    place.label = label_of(node.place);
    // The axes of a grid that is laid now are the map's.
    place.map_from_place = {node.pose.x, node.pose.y, 0.0};
    fused.add(place,
              std::make_shared<const core::EvidenceGrid>(sonar.build(
                  core::movedReadings(*node.readings, {0.0, 0.0, node.pose.yaw}), making.grid)));
    drawn.places.push_back(place);
  }
  drawn.links = linksOf(map);
  fused.update();
  drawn.cells = fused.cells();
  return drawn;
}

void writeMapPicture(const DrawnMap& map, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << toPng(mapPicture(map), kPixels);
  file.close();
  if (!file) throw std::runtime_error("cannot write the picture " + path);
}

}  // namespace place_memory::picture
