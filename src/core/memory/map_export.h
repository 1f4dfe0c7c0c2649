#ifndef PLACE_MEMORY_CORE_MEMORY_MAP_EXPORT_H
#define PLACE_MEMORY_CORE_MEMORY_MAP_EXPORT_H

#include <functional>
#include <string>
#include <vector>

#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {

/// Writes the map for other programs into a folder, which is made where there is none: places.csv,
/// links.csv, map.graphml, and as map_server reads them the building's map as building.pgm with
/// building.yaml, and each place as places/ID.pgm with places/ID.yaml. `grid_of` gives a place's
/// grid, with cells of `cell_size` [m]; `prior` is the probability of unsensed cells, in (0, 1).
/// Returns the paths of the files. Throws std::runtime_error naming what cannot be written, and
/// what `grid_of` throws.
std::vector<std::string> exportMap(const MapSnapshot& map,
                                   const std::function<EvidenceGrid(PlaceId)>& grid_of,
                                   double cell_size, double prior, const std::string& folder);

/// As hexadecimal digits.
std::string identityInWords(const PlaceIdentity& identity);

/// The tables and the graph as they stand in the files.
std::string placesAsCsv(const MapSnapshot& map);
std::string linksAsCsv(const MapSnapshot& map);
std::string mapAsGraphml(const MapSnapshot& map);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_MAP_EXPORT_H
