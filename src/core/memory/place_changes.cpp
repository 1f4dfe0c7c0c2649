#include "core/memory/place_changes.h"

#include "core/sensing/moved_readings.h"
#include "core/sensing/scan_changes.h"

namespace place_memory::core {

std::vector<PlaceChange> changesSinceLearned(const PlaceMap& map, const PlaceStore& store,
                                             const SonarModel& sonar, const GridGeometry& geometry,
                                             const GridChangeOptions& options) {
  std::vector<PlaceChange> changes;
  for (const Place& place : map.places()) {
    const std::vector<SonarReading> readings = store.readings(place.id);
    if (readings.empty()) continue;
    const EvidenceGrid learned = sonar.build(readings, geometry);
    for (const GridChange& change : changesBetween(learned, store.grid(place.id), options)) {
      changes.push_back({place.id, change});
    }
  }
  return changes;
}

std::vector<GridChange> changesSeen(const PlaceStore& store, PlaceId place, const Scan& scan,
                                    const Pose2d& place_from_scan, const SonarModelOptions& sonar) {
  const EvidenceGrid grid = store.grid(place);
  const std::vector<SonarReading> learned = store.readings(place);
  const std::vector<SonarReading> now = movedReadings(scan.readings, place_from_scan);
  if (learned.empty()) {
    return changesBetween(grid, SonarModel(sonar).build(now, grid.geometry()));
  }
  return changesBetween(learned, now, sonar, grid.geometry());
}

}  // namespace place_memory::core
