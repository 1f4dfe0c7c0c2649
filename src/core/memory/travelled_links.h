#ifndef PLACE_MEMORY_CORE_MEMORY_TRAVELLED_LINKS_H
#define PLACE_MEMORY_CORE_MEMORY_TRAVELLED_LINKS_H

#include <map>
#include <utility>
#include <vector>

#include "core/memory/place_travels.h"
#include "place_memory/core/link_learning.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// What travels between places make of the links of a map: those that are missing are added, and
/// links learn from each travel that is newer than what they know.
class TravelledLinks {
 public:
  /// `map` must outlive it.
  TravelledLinks(const PlaceMap& map, const LinkLearningOptions& learning)
      : map_(map), learning_(learning) {}

  /// By where the robot stood, in the frames of the grids of the two places, when those were made.
  void add(const PlaceTravel& travel, const Pose2d& from_from_robot, const Pose2d& to_from_robot);
  /// In an order in which they can be made.
  const std::vector<MapEdit>& edits() const { return edits_; }

 private:
  using Ends = std::pair<PlaceId, PlaceId>;

  const PlaceMap& map_;
  const LinkLearningOptions learning_;
  std::map<Ends, PlaceLink> links_;  ///< by the lower and the higher id, once the edits are made
  std::vector<MapEdit> edits_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_TRAVELLED_LINKS_H
