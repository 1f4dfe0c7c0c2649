#include "node/map/nearest_places.h"

#include <algorithm>
#include <cmath>

namespace place_memory::node {

std::vector<const core::Place*> nearestPlaces(const std::vector<core::Place>& places,
                                              const core::Pose2d& to, std::size_t count) {
  std::vector<const core::Place*> near;
  near.reserve(places.size());
  for (const core::Place& place : places) near.push_back(&place);
  const auto distance = [&to](const core::Place& place) {
    return std::hypot(place.map_from_place.x - to.x, place.map_from_place.y - to.y);
  };
  const std::size_t found = std::min(near.size(), count);
  std::partial_sort(
      near.begin(), near.begin() + static_cast<std::ptrdiff_t>(found), near.end(),
      [&](const core::Place* a, const core::Place* b) { return distance(*a) < distance(*b); });
  near.resize(found);
  return near;
}

}  // namespace place_memory::node
