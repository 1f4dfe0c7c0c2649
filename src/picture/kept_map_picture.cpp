#include "picture/kept_map_picture.h"

#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/sensing/moved_readings.h"

namespace place_memory::picture {
namespace {

constexpr int kPixels = 1400;   // along the longer side
constexpr int kMapSession = 1;  // in whose frame a mapper's map lies

/// The place that the robot came from, along the way.
core::PlaceId previousPlace(const std::vector<core::ScanNode>& nodes, const core::ScanNode& node) {
  std::optional<core::NodeIndex> before = node.before;
  while (before && nodes[*before].place == core::kNoPlace) before = nodes[*before].before;
  return before ? nodes[*before].place : core::kNoPlace;
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
    core::PlaceLink link;
    link.first = previousPlace(map.nodes, node);
    link.second = node.place;
    drawn.links.push_back(link);
  }
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
