#ifndef PLACE_MEMORY_TEST_CORE_MAPPING_KNOWN_PLACES_H
#define PLACE_MEMORY_TEST_CORE_MAPPING_KNOWN_PLACES_H

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <random>
#include <string>

#include "core/mapping/fused_map.h"

namespace place_memory::core {

using GridPointer = std::shared_ptr<const EvidenceGrid>;

/// Some boxes of evidence.
inline GridPointer randomGrid(std::mt19937& engine, double cell_size = kDefaultCellSize) {
  auto grid = std::make_shared<EvidenceGrid>(GridGeometry{cell_size});
  std::uniform_int_distribution<int> cell(0, kGridSize - 1);
  std::uniform_int_distribution<int> evidence(-120, 120);
  for (int box = 0; box < 12; ++box) {
    const int row = cell(engine), column = cell(engine), value = evidence(engine);
    for (int i = row; i < std::min(row + 9, kGridSize); ++i) {
      for (int j = column; j < std::min(column + 14, kGridSize); ++j) grid->add(i, j, value);
    }
  }
  return grid;
}

inline Place makePlace(PlaceId id, const Pose2d& pose, SessionId session = kFirstSession) {
  Place place;
  place.id = id;
  place.label = std::to_string(id);
  place.map_from_place = pose;
  place.session = session;
  return place;
}

struct Known {
  Place place;
  GridPointer grid;
};
using KnownPlaces = std::map<PlaceId, Known>;

inline FusedMap fromScratch(const FusedMapOptions& options, const KnownPlaces& places) {
  FusedMap map(options, GridGeometry{});
  for (const auto& [id, known] : places) map.add(known.place, known.grid);
  map.update();
  return map;
}

inline void expectSame(const FusedCells& one, const FusedCells& other) {
  ASSERT_EQ(one.columns, other.columns);
  ASSERT_EQ(one.rows, other.rows);
  EXPECT_EQ(one.left, other.left);
  EXPECT_EQ(one.bottom, other.bottom);
  EXPECT_TRUE(one.evidence == other.evidence);
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_MAPPING_KNOWN_PLACES_H
