#ifndef PLACE_MEMORY_CORE_MEMORY_PLACE_CHANGES_H
#define PLACE_MEMORY_CORE_MEMORY_PLACE_CHANGES_H

#include <vector>

#include "core/grid/grid_changes.h"
#include "core/store/place_store.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// What has changed at a place.
struct PlaceChange {
  PlaceId place = kNoPlace;
  GridChange change;
};

/// What has changed at the places of a store since they were learned, as far as scans were folded
/// into them: their grids against the readings they were learned from. Places whose readings are
/// not known are left out. Throws StoreError.
std::vector<PlaceChange> changesSinceLearned(const PlaceMap& map, const PlaceStore& store,
                                             const SonarModel& sonar, const GridGeometry& geometry,
                                             const GridChangeOptions& options = {});

/// What a scan that was RECOGNIZED as a place shows to have changed there since it was learned, by
/// the readings it was learned from; by its grid where they are not known. `place_from_scan` is the
/// alignment. Throws StoreError.
std::vector<GridChange> changesSeen(const PlaceStore& store, PlaceId place, const Scan& scan,
                                    const Pose2d& place_from_scan, const SonarModelOptions& sonar);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_PLACE_CHANGES_H
