#ifndef PLACE_MEMORY_CORE_MEMORY_DRIVEN_PLACES_H
#define PLACE_MEMORY_CORE_MEMORY_DRIVEN_PLACES_H

#include <set>
#include <string>
#include <vector>

#include "core/map/kept_map.h"
#include "core/store/place_store.h"
#include "place_memory/core/link_learning.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// What the map of a drive and the map of places have to do with each other: what the mapper makes
/// a place is a place, and places that were learned otherwise are nodes of the mapper's map.
class DrivenPlaces {
 public:
  DrivenPlaces(double cell_size, const SonarModelOptions& sonar,
               const LinkLearningOptions& learning)
      : geometry_{cell_size}, sonar_(sonar), learning_(learning) {}

  /// What a mapper takes up: see PlaceMemory::drivenMap(). Throws StoreError.
  KeptMap take(const PlaceMap& map, const PlaceStore& store);

  /// The edits by which the map of places becomes what the drive has made of it. Ids below
  /// `next_id` were given before: a place with such a one that is not in the map was removed by
  /// somebody else, and stays so. Places between which the robot went are linked. `only_new`: of
  /// all edits those that add a place, and link it.
  std::vector<MapEdit> edits(const PlaceMap& map, const KeptMap& drive, PlaceId next_id,
                             bool only_new) const;
  /// The edits by which links of the map of places learn from the drive, and nothing else changes.
  std::vector<MapEdit> travels(const PlaceMap& map, const KeptMap& drive) const;
  /// The edits were made.
  void kept(const PlaceMap& map, const KeptMap& drive);

 private:
  ScanNode nodeOf(const Place& place, const PlaceStore& store) const;
  PlaceAdded added(const ScanNode& node, const PlaceMap& map) const;

  GridGeometry geometry_;
  SonarModel sonar_;
  LinkLearningOptions learning_;
  std::set<PlaceId> kept_;  ///< places of the drive, when it was kept last
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_DRIVEN_PLACES_H
