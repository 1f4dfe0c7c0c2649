#include "core/memory/place_changes.h"

#include "core/sensing/moved_readings.h"

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

std::vector<GridChange> changesSeen(const EvidenceGrid& grid, const Scan& scan,
                                    const Pose2d& place_from_scan, const SonarModel& sonar,
                                    const GridChangeOptions& options) {
  const EvidenceGrid now =
      sonar.build(movedReadings(scan.readings, place_from_scan), grid.geometry());
  return changesBetween(grid, now, options);
}

}  // namespace place_memory::core
