#ifndef PLACE_MEMORY_BENCHMARK_SPLICED_PLACES_H
#define PLACE_MEMORY_BENCHMARK_SPLICED_PLACES_H

#include <cstdint>
#include <vector>

#include "simulated_places.h"

namespace place_memory::measure {

/// Makes places that nobody simulated, a thousand times faster than the simulator, whose scores as
/// strangers are those of simulated ones (benchmark `strangers` compares the two).
///
/// A place is spliced from two simulated grids of one building, so that its furniture and the
/// directions of its walls go together: the second by any number of quarter turns, put in place of
/// the first beyond a line near the rim; the whole then by quarter turns and perhaps mirrored. No
/// cell is resampled, so the edges stay as sharp as the sonar model drew them.
class SplicedPlaces {
 public:
  /// `simulated` stays where it is; only its buildings from `first_building` on are used.
  SplicedPlaces(const std::vector<KnownPlace>& simulated, std::size_t first_building);

  /// The same number gives the same place. Thread-safe.
  KnownPlace make(std::uint64_t number) const;

 private:
  struct Building {
    std::size_t first;
    std::size_t count;
  };

  const std::vector<KnownPlace>& simulated_;
  std::vector<Building> buildings_;
};

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_SPLICED_PLACES_H
