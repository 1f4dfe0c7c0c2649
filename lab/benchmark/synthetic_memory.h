#ifndef PLACE_MEMORY_BENCHMARK_SYNTHETIC_MEMORY_H
#define PLACE_MEMORY_BENCHMARK_SYNTHETIC_MEMORY_H

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/index/place_index.h"
#include "core/recognize/place_frame.h"
#include "simulated_places.h"

namespace place_memory::measure {

/// Of the simulated places so many have queries; spliced places are made from the others, so that
/// none looks like the place of a query because it was made from that.
constexpr std::size_t kQueryPlaces = 1000;
/// So many places are simulated for the largest memories; the rest of those is spliced.
constexpr std::size_t kSimulatedPlaces = 5000;

/// What recognition needs of all places, which have the ids 1, 2, ...
struct KnownMap {
  core::PlaceIndex index;
  std::vector<core::PlaceFrame> frames;

  core::LookUpFrames lookUp() const {
    return [this](const std::vector<core::PlaceId>& places) {
      std::vector<core::PlaceFrame> found;
      for (const core::PlaceId id : places)
        found.push_back(frames[static_cast<std::size_t>(id) - 1]);
      return std::optional(found);
    };
  }
};

/// A memory of any size, the same one for the same size: simulated places, and beyond
/// kSimulatedPlaces spliced ones, with the simulated ones spread evenly among them.
class SyntheticMemory {
 public:
  SyntheticMemory(const SimulatedPlaces& simulated, std::size_t size);

  std::size_t size() const { return size_; }

  /// Calls with every place, in the order of its id: 1 to size().
  void forEach(const std::function<void(core::PlaceId, const KnownPlace&)>& call) const;

  KnownMap map() const;

  /// Up to `count` queries, evenly from all that have their place in the memory.
  std::vector<const Query*> queries(std::size_t count, bool any_heading) const;

  /// Whether the answer to the query is right.
  bool isRight(const Query& query, core::PlaceId id) const;

 private:
  /// Simulated places among the first `places` of the memory.
  std::size_t simulatedAmong(std::size_t places) const;

  const SimulatedPlaces& simulated_;
  std::size_t size_;
  std::size_t simulated_count_;
};

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_SYNTHETIC_MEMORY_H
