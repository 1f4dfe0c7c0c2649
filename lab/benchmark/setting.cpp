#include "setting.h"

#include <algorithm>

#include "config/load_parameters.h"

namespace place_memory::measure {

Setting::Setting(const Options& options)
    : options_(options), parameters_(config::loadParameters({})) {}

const SimulatedPlaces& Setting::simulated() {
  if (!simulated_) {
    const std::size_t largest = std::max(options_.max_places, options_.max_stored);
    simulated_ =
        std::make_unique<SimulatedPlaces>(simulatePlaces(std::min(largest, kSimulatedPlaces)));
  }
  return *simulated_;
}

const KnownMap& Setting::map(std::size_t size) {
  if (map_size_ != size) {
    dropMap();
    map_ = memory(size).map();
    map_size_ = size;
  }
  return map_;
}

void Setting::dropMap() {
  map_ = {};
  map_size_ = 0;
}

std::size_t Setting::affordableQueries(std::size_t size, double seconds_per_place) const {
  constexpr double kFewest = 3.0;
  const double affordable = options_.patience / (seconds_per_place * static_cast<double>(size));
  return std::min(options_.queries, static_cast<std::size_t>(std::max(affordable, kFewest)));
}

std::string benchmarkName(const std::string& what, bool any_heading, std::size_t places) {
  return what + (any_heading ? "/any/" : "/local/") + std::to_string(places);
}

}  // namespace place_memory::measure
