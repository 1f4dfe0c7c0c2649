#ifndef PLACE_MEMORY_CORE_MEMORY_DRIVEN_MAP_H
#define PLACE_MEMORY_CORE_MEMORY_DRIVEN_MAP_H

#include <optional>
#include <string>
#include <vector>

#include "core/map/kept_map.h"
#include "core/store/place_store.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// A map that is made while the robot drives, in a store of places: what the mapper makes a place
/// is a place of the store, and places that were learned otherwise are nodes of the map.
class DrivenMap {
 public:
  /// Throws what PlaceStore throws.
  DrivenMap(const std::string& path, double cell_size, const SonarModelOptions& sonar,
            const StoreOpening& opening = {});

  /// What a mapper takes up. Places whose readings are not known stay out of it, and in the store.
  const KeptMap& kept() const { return kept_; }
  /// What is damaged in the store and was left out, a sentence each.
  const std::vector<std::string>& setAside() const { return store_.setAside(); }

  /// Keeps what the mapper has made of it: places that it has no more go. In one transaction;
  /// throws StoreError where it cannot be kept, the store is then as it was.
  void keep(const KeptMap& map);

  /// Empty where there is no such place.
  std::string labelOf(PlaceId id) const;

 private:
  ScanNode nodeOf(const Place& place) const;
  PlaceAdded added(const ScanNode& node) const;
  Pose2d placeFromRobot(const ScanNode& node) const;
  /// The way by which the robot came to a place from the one before, as odometry measured it.
  std::optional<PlaceLink> linkOf(const ScanNode& node, const KeptMap& map) const;
  std::string freeLabel(PlaceId id) const;

  GridGeometry geometry_;
  SonarModel sonar_;
  PlaceStore store_;
  PlaceMap map_;
  KeptMap kept_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_DRIVEN_MAP_H
