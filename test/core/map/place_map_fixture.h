#ifndef PLACE_MEMORY_TEST_CORE_MAP_PLACE_MAP_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_MAP_PLACE_MAP_FIXTURE_H

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

using std::chrono::nanoseconds;

inline Place makePlace(PlaceId id, const std::string& label) {
  Place place;
  place.id = id;
  place.label = label;
  return place;
}

inline PlaceLink makeLink(PlaceId first, PlaceId second) {
  PlaceLink link;
  link.first = first;
  link.second = second;
  link.first_from_second = {1.0, 2.0, 0.3};
  return link;
}

inline MapEdit added(PlaceId id, const std::string& label) {
  return PlaceAdded{makePlace(id, label), nullptr, nullptr};
}

inline void edit(PlaceMap& map, std::vector<MapEdit> edits) {
  map.apply({map.version() + 1, nanoseconds(7), std::move(edits)});
}

inline std::vector<PlaceId> idsOf(const PlaceMap& map) {
  std::vector<PlaceId> ids;
  for (const Place& place : map.places()) ids.push_back(place.id);
  return ids;
}

inline std::vector<std::pair<PlaceId, PlaceId>> endsOf(const PlaceMap& map) {
  std::vector<std::pair<PlaceId, PlaceId>> ends;
  for (const PlaceLink& link : map.links()) ends.emplace_back(link.first, link.second);
  return ends;
}

using Ends = std::vector<std::pair<PlaceId, PlaceId>>;
using Ids = std::vector<PlaceId>;

inline void expectSame(const PlaceMap& one, const PlaceMap& other) {
  EXPECT_EQ(one.version(), other.version());
  EXPECT_EQ(one.stamp(), other.stamp());
  EXPECT_TRUE(one.places() == other.places());
  EXPECT_TRUE(one.links() == other.links());
  for (const Place& place : one.places()) {
    EXPECT_EQ(other.find(place.label), other.find(place.id));
    EXPECT_EQ(one.neighbours(place.id), other.neighbours(place.id));
  }
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_MAP_PLACE_MAP_FIXTURE_H
