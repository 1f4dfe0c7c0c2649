#ifndef PLACE_MEMORY_TEST_ENDURANCE_MAP_RECORD_H
#define PLACE_MEMORY_TEST_ENDURANCE_MAP_RECORD_H

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/store/place_store.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place_map.h"

namespace place_memory {

/// The whole map at one version: every place and link, and of each place's grid a hash.
struct MapRecord {
  std::uint64_t version = 0;
  std::vector<core::Place> places;     ///< by rising id
  std::vector<core::PlaceLink> links;  ///< as PlaceMap::links() has them
  std::map<core::PlaceId, std::uint64_t> grids;

  bool operator==(const MapRecord& other) const {
    return version == other.version && places == other.places && links == other.links &&
           grids == other.grids;
  }
};

std::uint64_t hashOf(const core::EvidenceGrid& grid);

/// Throws StoreError where it cannot all be read.
MapRecord recordOf(const core::PlaceStore& store);

/// As bytes, and back to the bit. Nothing where they are none.
std::string packed(const MapRecord& map);
std::optional<MapRecord> unpackedMap(const std::string& bytes);

/// In what the two differ, in a sentence; empty: in nothing.
std::string difference(const MapRecord& expected, const MapRecord& found);

}  // namespace place_memory

#endif  // PLACE_MEMORY_TEST_ENDURANCE_MAP_RECORD_H
