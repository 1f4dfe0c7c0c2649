#ifndef PLACE_MEMORY_CORE_EXPLORE_SURVEYED_MAP_H
#define PLACE_MEMORY_CORE_EXPLORE_SURVEYED_MAP_H

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "core/explore/heard_walls.h"
#include "core/mapping/fused_map.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

struct SurveyedCells {
  FusedCells cells;           ///< walls have the highest evidence
  std::vector<Pose2d> trail;  ///< where the robot was, in the map
};

/// What a robot that explores knows of the building: the map that places make, what it has sensed
/// just now, of which no place is made yet, and the walls that it heard head on.
///
/// What was heard hangs on the place nearest to where the robot heard it, and moves with that. A
/// call of cells() costs what was heard since the one before; where places moved, walls are laid
/// anew, some ten milliseconds for a way of some hundred metres. Not thread-safe.
class SurveyedMap {
 public:
  SurveyedMap(const FusedMapOptions& options, const GridGeometry& geometry,
              const SonarModelOptions& sonar, FusedMap::GridOf grid_of = nullptr);

  /// As FusedMap has them.
  void add(const Place& place, std::shared_ptr<const EvidenceGrid> grid = nullptr);
  void apply(const MapChange& change);

  /// A reading in the base's frame, and where odometry had that; in the order of stamps.
  void hear(const Pose2d& odom_from_base, const SonarReading& reading);
  /// Odometry starts anew: what was heard last lies elsewhere.
  void restart();

  /// With odometry's frame as it lies in the map now.
  SurveyedCells cells(const Pose2d& map_from_odom);

 private:
  /// Readings from one spot.
  struct Station {
    Pose2d odom_from_base;
    double way = 0.0;                    ///< [m]
    std::vector<SonarReading> readings;  ///< in the base's frame
  };
  /// One that is laid.
  struct Anchored {
    PlaceId place = kNoPlace;  ///< that it hangs on; kNoPlace: on the map
    Pose2d place_from_base;
    std::vector<SonarReading> readings;
  };

  void layNewest(const Pose2d& map_from_odom);
  void anchor(const Pose2d& map_from_odom);
  void moveTo(PlaceId id, const Pose2d& map_from_place);
  void layWalls(const Anchored& station);
  Pose2d placePose(PlaceId id) const;
  PlaceId nearest(const Pose2d& spot) const;
  void loosen(PlaceId id);

  GridGeometry geometry_;
  SonarModel sonar_;
  FusedMap fused_;
  HeardWalls walls_;
  std::map<PlaceId, Pose2d> poses_;  ///< of the places, as they are laid
  std::deque<Station> newest_;
  std::size_t anchored_of_newest_ = 0;
  std::vector<Anchored> stations_;
  bool moved_ = false;  ///< a place, since walls were laid
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_EXPLORE_SURVEYED_MAP_H
