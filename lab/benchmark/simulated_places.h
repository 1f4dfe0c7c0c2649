#ifndef PLACE_MEMORY_BENCHMARK_SIMULATED_PLACES_H
#define PLACE_MEMORY_BENCHMARK_SIMULATED_PLACES_H

#include <cstddef>
#include <vector>

#include "place_memory/core/scan.h"

namespace place_memory::measure {

/// A place as the simulated robot learned it.
struct KnownPlace {
  std::size_t building = 0;
  core::Pose2d map_from_place;
  core::EvidenceGrid grid;
};

/// A scan of a robot that came back after the building had changed.
struct Query {
  core::Scan scan;
  std::vector<std::size_t> accept;  ///< every known place that is right, by its number
};

struct SimulatedPlaces {
  std::vector<KnownPlace> places;  ///< building by building
  std::vector<Query> local;        ///< one a place; the compass is off by up to 30 degrees
  std::vector<Query> any_heading;  ///< one a place; no compass
};

/// The first `count` places of generated buildings of every kind but the arena, one after the
/// other, as the paper's robot of 16 sonars learns them, and a query for each of them. The same
/// count gives the same places, and a smaller count the first of them. Each building has a part of
/// the map of its own.
SimulatedPlaces simulatePlaces(std::size_t count);

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_SIMULATED_PLACES_H
