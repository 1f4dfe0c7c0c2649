#ifndef PLACE_MEMORY_PICTURE_KEPT_MAP_PICTURE_H
#define PLACE_MEMORY_PICTURE_KEPT_MAP_PICTURE_H

#include <functional>
#include <string>

#include "core/map/kept_map.h"
#include "core/mapping/fused_map.h"
#include "picture/map_picture.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::picture {

/// How readings become a map.
struct MapMaking {
  core::FusedMapOptions fused;
  core::GridGeometry grid;  ///< of places
  core::SonarModelOptions sonar;
};

/// What a mapper has made, as it lies in it: without what is not joined to the map, and without a
/// way. `label_of`: of a place.
DrawnMap drawnMap(const core::KeptMap& map, const MapMaking& making,
                  const std::function<std::string(core::PlaceId)>& label_of);

/// Writes the picture of a map as a PNG file. Throws std::runtime_error where it cannot be written.
void writeMapPicture(const DrawnMap& map, const std::string& path);

}  // namespace place_memory::picture

#endif  // PLACE_MEMORY_PICTURE_KEPT_MAP_PICTURE_H
