#include "picture/map_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "picture/grid_picture.h"
#include "picture/label_layout.h"
#include "picture/scale_bar.h"
#include "picture/svg_text.h"

namespace place_memory::picture {
namespace {

constexpr Color kUnsensed{226, 226, 220};
constexpr Color kPlace{32, 96, 192};
constexpr Color kLink{110, 150, 210};
constexpr Color kWay{240, 150, 40};
constexpr Color kBegin{30, 150, 60};
constexpr Color kEnd{210, 40, 40};
constexpr Color kInk{25, 30, 60};

// Labels are sought room for among so many; that of more places would take long, and be tiny.
constexpr std::size_t kMostLabelled = 2000;

/// What of the map a picture shows [m].
struct Extent {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = left;
  double top = right;

  void include(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    bottom = std::min(bottom, y);
    top = std::max(top, y);
  }
};

Extent extentOf(const std::vector<core::Place>& places) {
  Extent extent;
  for (const core::Place& place : places) {
    extent.include(place.map_from_place.x, place.map_from_place.y);
  }
  return extent;
}

/// Around what is sensed: cells come in whole tiles.
void includeSensed(const core::FusedCells& cells, Extent& extent) {
  std::size_t cell = 0;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      if (cells.evidence[cell++] == 0) continue;
      extent.include(cells.left + column * cells.resolution, cells.bottom + row * cells.resolution);
    }
  }
}

Raster rasterOf(const core::FusedCells& cells) {
  Raster raster{{cells.left, cells.bottom}, cells.resolution, cells.columns, cells.rows, {}};
  raster.colors.reserve(cells.evidence.size());
  for (const std::int8_t evidence : cells.evidence) {
    raster.colors.push_back(evidence == 0 ? kUnsensed : shadeOf(evidence));
  }
  return raster;
}

/// Draws with one size of things, by the size of the map.
class MapDrawing {
 public:
  explicit MapDrawing(const DrawnMap& map)
      : map_(map), window_(map.window ? *map.window : windowOf(map)) {
    const double size = std::max({window_.upper_right.x - window_.lower_left.x,
                                  window_.upper_right.y - window_.lower_left.y, 1.0});
    radius_ = std::clamp(0.2, size / 250.0, size / 90.0);
  }

  Picture draw() {
    picture_.background = map_.cells.evidence.empty() ? Color{255, 255, 255} : kUnsensed;
    // Labels stand to the right, the scale below.
    picture_.lower_left = {window_.lower_left.x - 4.0 * radius_,
                           window_.lower_left.y - 8.0 * radius_};
    picture_.upper_right = {window_.upper_right.x + 16.0 * radius_,
                            window_.upper_right.y + 4.0 * radius_};
    if (!map_.cells.evidence.empty()) picture_.shapes.emplace_back(rasterOf(map_.cells));
    drawWays();
    drawLinks();
    drawPlaces();
    drawLabels();
    addScaleBar(picture_, 3.0 * radius_);
    return std::move(picture_);
  }

 private:
  void drawWays() {
    for (const auto& way : map_.ways) {
      Line line{{}, 0.45 * radius_, kWay};
      for (const core::Pose2d& pose : way) {
        const bool is_new =
            line.points.empty() || std::hypot(line.points.back().x - pose.x,
                                              line.points.back().y - pose.y) > 0.25 * radius_;
        if (is_new) line.points.push_back({pose.x, pose.y});
      }
      picture_.shapes.emplace_back(std::move(line));
    }
  }

  void drawLinks() {
    std::map<core::PlaceId, Point> at;
    for (const core::Place& place : map_.places) {
      at[place.id] = {place.map_from_place.x, place.map_from_place.y};
    }
    for (const core::PlaceLink& link : map_.links) {
      const auto first = at.find(link.first);
      const auto second = at.find(link.second);
      if (first == at.end() || second == at.end()) continue;
      picture_.shapes.emplace_back(Line{{first->second, second->second}, radius_ / 3.0, kLink});
    }
  }

  void drawPlaces() {
    for (const core::Place& place : map_.places) {
      const core::Pose2d& at = place.map_from_place;
      picture_.shapes.emplace_back(
          Disc{{at.x, at.y},
               radius_,
               kPlace,
               place.label + " (" + decimal(at.x, 2) + ", " + decimal(at.y, 2) + ") m"});
      discs_.push_back({at.x, at.y});
    }
    drawEnd(true, kBegin);
    drawEnd(false, kEnd);
  }

  void drawEnd(bool is_first, const Color& color) {
    if (map_.ways.empty()) return;
    const core::Pose2d& pose = is_first ? map_.ways.front().front() : map_.ways.back().back();
    picture_.shapes.emplace_back(Disc{{pose.x, pose.y}, 1.3 * radius_, color, ""});
    discs_.push_back({pose.x, pose.y});
  }

  void drawLabels() {
    if (map_.places.size() > kMostLabelled) return;
    LabelLayout layout(discs_, radius_, 2.2 * radius_);
    for (const core::Place& place : map_.places) {
      const auto spot = layout.place({place.map_from_place.x, place.map_from_place.y}, place.label);
      if (spot) {
        picture_.shapes.emplace_back(Text{*spot, 2.2 * radius_, place.label, kInk});
      }
    }
  }

  const DrawnMap& map_;
  Window window_;
  double radius_ = 0.0;  ///< of a place [m]
  Picture picture_;
  std::vector<Point> discs_;
};

core::FusedCells fused(const std::vector<core::Place>& places,
                       const core::FusedMap::GridOf& grid_of, double cell_size) {
  if (!grid_of) return {};
  core::FusedMap map({}, core::GridGeometry{cell_size}, grid_of);
  for (const core::Place& place : places) map.add(place);
  map.update();
  return map.cells();
}

}  // namespace

Window windowOf(const DrawnMap& map) {
  Extent extent = extentOf(map.places);
  for (const auto& way : map.ways) {
    for (const core::Pose2d& pose : way) extent.include(pose.x, pose.y);
  }
  includeSensed(map.cells, extent);
  if (!(extent.left <= extent.right)) extent.include(0.0, 0.0);
  return {{extent.left, extent.bottom}, {extent.right, extent.top}};
}

Picture mapPicture(const DrawnMap& map) { return MapDrawing(map).draw(); }

std::string mapPictures(const core::MapSnapshot& map, const core::FusedMap::GridOf& grid_of,
                        double cell_size) {
  std::map<core::SessionId, std::vector<core::Place>> sessions;
  for (const core::Place& place : map.places) sessions[place.session].push_back(place);
  std::string text;
  for (const auto& [session, places] : sessions) {
    const Extent extent = extentOf(places);
    text +=
        "<h3>Session " + std::to_string(session) + ": " + std::to_string(places.size()) +
        (places.size() == 1 ? " place" : " places") + "</h3>\n<p>" +
        decimal(extent.right - extent.left, 1) + " m by " + decimal(extent.top - extent.bottom, 1) +
        " m</p>\n" +
        toSvg(mapPicture({fused(places, grid_of, cell_size), places, map.links, {}, {}}), "map");
  }
  return text;
}

}  // namespace place_memory::picture
