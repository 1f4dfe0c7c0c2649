#ifndef PLACE_MEMORY_PICTURE_MAP_PICTURE_H
#define PLACE_MEMORY_PICTURE_MAP_PICTURE_H

#include <optional>
#include <string>
#include <vector>

#include "core/mapping/fused_map.h"
#include "picture/picture.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::picture {

/// A rectangle of the map's frame.
struct Window {
  Point lower_left;
  Point upper_right;
};

/// What a picture of a map shows, all in one frame.
struct DrawnMap {
  core::FusedCells cells;  ///< of the building; none: they are not drawn
  std::vector<core::Place> places;
  std::vector<core::PlaceLink> links;
  /// Driven by the robot, from stretch to stretch: between them where it was is not known.
  std::vector<std::vector<core::Pose2d>> ways;
  std::optional<Window> window;  ///< that is shown; nothing: all there is
};

/// All there is.
Window windowOf(const DrawnMap& map);

/// Seen from above, x to the right: dark is occupied, white is empty; places are discs, with their
/// labels where these leave each other room, links are lines between them. The way begins at a
/// green dot and ends at a red one.
Picture mapPicture(const DrawnMap& map);

/// As SVG, a picture a session, as each session has a frame of its own. `grid_of`, where given, is
/// asked for the grids of the places, to draw the building below them.
std::string mapPictures(const core::MapSnapshot& map, const core::FusedMap::GridOf& grid_of,
                        double cell_size);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_MAP_PICTURE_H
