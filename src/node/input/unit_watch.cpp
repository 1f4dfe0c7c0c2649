#include "node/input/unit_watch.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace place_memory::node {
namespace {

constexpr int kMany = 20;            // echoes
constexpr double kFarthest = 100.0;  // max_range of a sonar in air, and of most lasers [m]

}  // namespace

std::string UnitWatch::note(const AdaptedReading& reading, const SensorRegistry& registry) {
  const core::Measurement& measurement = reading.measurement;
  if (reading.reject) return {};
  std::ostringstream text;
  if (measurement.spec.max_range > kFarthest) {
    text << registry.nameOf(measurement.sensor) << " has a max_range of "
         << measurement.spec.max_range
         << " m: are its limits and ranges in metres, not centimetres or millimetres?";
    return text.str();
  }
  if (!std::isfinite(measurement.range)) return {};
  Count& count = counts_[measurement.sensor];
  count.within = count.within || measurement.range <= reach_;
  if (count.within) return {};
  count.beyond = std::min(count.beyond + 1, kMany);
  if (count.beyond < kMany) return {};
  text << "every range of " << registry.nameOf(measurement.sensor)
       << " lies beyond the grid, which reaches " << reach_
       << " m (the newest: " << measurement.range
       << " m): are they in metres, or is grid/cell_size too small for the rooms?";
  return text.str();
}

}  // namespace place_memory::node
