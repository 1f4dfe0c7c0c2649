#ifndef PLACE_MEMORY_CORE_MEMORY_DRIVEN_PLACES_H
#define PLACE_MEMORY_CORE_MEMORY_DRIVEN_PLACES_H

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/map/kept_map.h"
#include "core/store/place_store.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// What the map of a drive and the map of places have to do with each other: what the mapper makes
/// a place is a place, and places that were learned otherwise are nodes of the mapper's map.
class DrivenPlaces {
 public:
  DrivenPlaces(double cell_size, const SonarModelOptions& sonar)
      : geometry_{cell_size}, sonar_(sonar) {}

  /// What a mapper takes up: see PlaceMemory::drivenMap(). Throws StoreError.
  KeptMap take(const PlaceMap& map, const PlaceStore& store);

  /// The edits by which the map of places becomes what the drive has made of it. Ids below
  /// `next_id` were given before: a place with such a one that is not in the map was removed by
  /// somebody else, and stays so. `only_new`: of all edits those that add a place.
  std::vector<MapEdit> edits(const PlaceMap& map, const KeptMap& drive, PlaceId next_id,
                             bool only_new) const;
  /// Those edits were made.
  void kept(const PlaceMap& map, const KeptMap& drive);

 private:
  ScanNode nodeOf(const Place& place, const PlaceStore& store) const;
  PlaceAdded added(const ScanNode& node, const PlaceMap& map) const;
  /// The way by which the robot came to a place from the one before, as odometry measured it.
  static std::optional<PlaceLink> linkOf(const ScanNode& node, const KeptMap& drive,
                                         const PlaceMap& map);

  GridGeometry geometry_;
  SonarModel sonar_;
  std::set<PlaceId> kept_;  ///< places of the drive, when it was kept last
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_DRIVEN_PLACES_H
