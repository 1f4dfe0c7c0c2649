#include "synthetic_memory.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "spliced_places.h"
#include "support/parallel_for.h"

namespace place_memory::measure {

SyntheticMemory::SyntheticMemory(const SimulatedPlaces& simulated, std::size_t size)
    : simulated_(simulated),
      size_(size),
      simulated_count_(std::min(size, simulated.places.size())) {}

std::size_t SyntheticMemory::simulatedAmong(std::size_t places) const {
  return places * simulated_count_ / size_;
}

void SyntheticMemory::forEach(
    const std::function<void(core::PlaceId, const KnownPlace&)>& call) const {
  constexpr std::size_t kAtATime = 4096;
  std::optional<SplicedPlaces> spliced;
  if (size_ > simulated_count_) {
    spliced.emplace(simulated_.places, simulated_.places.at(kQueryPlaces).building + 1);
  }
  std::vector<KnownPlace> places;
  for (std::size_t first = 0; first < size_; first += kAtATime) {
    places.resize(std::min(kAtATime, size_ - first));
    support::parallelFor(places.size(), [&](std::size_t i) {
      const std::size_t number = first + i;
      const std::size_t before = simulatedAmong(number);
      const bool is_simulated = simulatedAmong(number + 1) > before;
      places[i] = is_simulated ? simulated_.places[before] : spliced->make(number);
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
      call(static_cast<core::PlaceId>(first + i + 1), places[i]);
    }
  }
}

KnownMap SyntheticMemory::map() const {
  core::PlaceIndex index;
  std::vector<core::PlaceFrame> frames;
  forEach([&](core::PlaceId id, const KnownPlace& place) {
    index.put(id, place.grid);
    frames.push_back({place.map_from_place});
  });
  return {std::move(index), std::move(frames)};
}

std::vector<const Query*> SyntheticMemory::queries(std::size_t count, bool any_heading) const {
  const std::size_t places = std::min(simulated_count_, kQueryPlaces);
  std::vector<const Query*> possible;
  for (const Query& query : any_heading ? simulated_.any_heading : simulated_.local) {
    if (*std::max_element(query.accept.begin(), query.accept.end()) < places) {
      possible.push_back(&query);
    }
  }
  std::vector<const Query*> chosen;
  count = std::min(count, possible.size());
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(possible[i * possible.size() / count]);
  return chosen;
}

bool SyntheticMemory::isRight(const Query& query, core::PlaceId id) const {
  const auto number = static_cast<std::size_t>(id) - 1;
  const std::size_t before = simulatedAmong(number);
  if (simulatedAmong(number + 1) == before) return false;
  return std::find(query.accept.begin(), query.accept.end(), before) != query.accept.end();
}

}  // namespace place_memory::measure
