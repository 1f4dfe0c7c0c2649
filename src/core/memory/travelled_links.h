#ifndef PLACE_MEMORY_CORE_MEMORY_TRAVELLED_LINKS_H
#define PLACE_MEMORY_CORE_MEMORY_TRAVELLED_LINKS_H

#include <map>
#include <utility>
#include <vector>

#include "core/memory/place_travels.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// What travels between places make of the links of a map: those that are missing are added, and
/// each travel that is newer than what a link knows counts for it.
class TravelledLinks {
 public:
  /// `map` must outlive it.
  explicit TravelledLinks(const PlaceMap& map) : map_(map) {}

  /// By where the robot stood, in the frames of the grids of the two places, when those were made.
  void add(const PlaceTravel& travel, const Pose2d& from_from_robot, const Pose2d& to_from_robot);
  void appendTo(std::vector<MapEdit>& edits) const;

 private:
  using Ends = std::pair<PlaceId, PlaceId>;

  const PlaceMap& map_;
  std::map<Ends, PlaceLink> added_;          // by the lower and the higher id
  std::map<Ends, LinkDirection> travelled_;  // of links that the map has, from and to
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_TRAVELLED_LINKS_H
