#ifndef PLACE_MEMORY_TEST_NODE_MAP_MAP_FIXTURE_H
#define PLACE_MEMORY_TEST_NODE_MAP_MAP_FIXTURE_H

#include <string>

#include "place_memory/core/place_memory.h"

namespace place_memory::node {

inline core::Place makePlace(core::PlaceId id, const std::string& label, double x) {
  core::Place place;
  place.id = id;
  place.label = label;
  place.map_from_place = {x, 2.0, 0.5};
  place.learned = std::chrono::milliseconds(12345);
  return place;
}

inline core::PlaceLink makeLink(core::PlaceId first, core::PlaceId second) {
  core::PlaceLink link;
  link.first = first;
  link.second = second;
  link.first_from_second = {3.0, 0.25, -0.5};
  link.covariance = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  return link;
}

/// a - b - c, three metres apart along x.
inline core::MapSnapshot makeChain() {
  core::MapSnapshot map;
  map.version = 5;
  map.stamp = std::chrono::seconds(7) + std::chrono::nanoseconds(8);
  map.places = {makePlace(1, "a", 0.0), makePlace(2, "b", 3.0), makePlace(3, "c", 6.0)};
  map.links = {makeLink(1, 2), makeLink(2, 3)};
  return map;
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_TEST_NODE_MAP_MAP_FIXTURE_H
