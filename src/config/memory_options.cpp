#include "config/memory_options.h"

namespace place_memory::config {

core::PlaceMemoryOptions memoryOptions(const Parameters& parameters) {
  core::PlaceMemoryOptions options;
  options.store_path = parameters.store;
  options.cell_size = parameters.grid.cell_size;
  options.recognizer = parameters.match.recognizer;
  options.adaptation = parameters.places;
  options.links = parameters.routes;
  options.sonar = parameters.sonar;
  return options;
}

core::FusedMapOptions fusedMapOptions(const Parameters& parameters) {
  core::FusedMapOptions options;
  options.resolution = parameters.map.resolution;
  options.most_cells = static_cast<std::size_t>(parameters.map.max_cells);
  return options;
}

}  // namespace place_memory::config
