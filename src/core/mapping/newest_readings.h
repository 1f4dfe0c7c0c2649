#ifndef PLACE_MEMORY_CORE_MAPPING_NEWEST_READINGS_H
#define PLACE_MEMORY_CORE_MAPPING_NEWEST_READINGS_H

#include <cstddef>
#include <optional>
#include <vector>

#include "core/grid/cell_planes.h"
#include "core/mapping/place_shelf.h"
#include "core/mapping/scan_graph.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// Share of what `seen` and `known` both know of things that stand about on which they agree, in
/// [0, 1]: cells seen occupied that are known to be, or have such a neighbour, against those known
/// to be empty and those known occupied that are seen empty. Nothing where that is too little.
std::optional<double> agreement(const CellPlanes& seen, const CellPlanes& known);

/// Whether the newest half of a scan's readings fits where the robot is thought to be. A scan that
/// was begun elsewhere looks like there for long; its newest readings do not.
class NewestReadings {
 public:
  /// Keeps references.
  NewestReadings(const ScanGraph& graph, const PlaceShelf& shelf, const SonarModelOptions& sonar,
                 double cell_size)
      : graph_(graph), shelf_(shelf), sonar_(sonar), geometry_{cell_size} {}

  struct Agreement {
    std::optional<double> newest;  ///< nothing where no ripe place is near, or too little is known
    bool disagrees = false;        ///< that is little
    bool contradicts = false;      ///< by far less than the older ones: it is elsewhere now
  };
  /// Agreement of a node's readings, the newest ones from `first` on, with the ripe place nearest
  /// to where they put the robot.
  Agreement agree(NodeIndex node, std::size_t first) const;

  /// Agreement of all readings of a node, had it been at `pose`, with a ripe place.
  std::optional<double> agreeWith(PlaceId place, NodeIndex node, const Pose2d& pose) const;

 private:
  std::optional<double> agree(NodeIndex node, std::size_t first, std::size_t last) const;
  std::optional<double> agree(PlaceId place, const std::vector<SonarReading>& readings,
                              const Pose2d& pose) const;

  const ScanGraph& graph_;
  const PlaceShelf& shelf_;
  SonarModel sonar_;
  GridGeometry geometry_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_NEWEST_READINGS_H
