#ifndef PLACE_MEMORY_CORE_MAP_INVERSE_CHANGE_H
#define PLACE_MEMORY_CORE_MAP_INVERSE_CHANGE_H

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// What of a place lies beside the map, as it is before the change.
struct PlaceContents {
  std::function<EvidenceGrid(PlaceId)> grid;
  std::function<std::vector<SonarReading>(PlaceId)> readings;
};

/// The edits that bring back what `edits`, which fit the map, are about to change. Nothing where
/// they would hold more than `most_bytes` of grids and readings. Throws what `contents` throws.
std::optional<std::vector<MapEdit>> inverseOf(const std::vector<MapEdit>& edits,
                                              const PlaceMap& before, const PlaceContents& contents,
                                              std::size_t most_bytes);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_INVERSE_CHANGE_H
