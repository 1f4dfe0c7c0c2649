#ifndef PLACE_MEMORY_CORE_MAPPING_SCAN_TYING_H
#define PLACE_MEMORY_CORE_MAPPING_SCAN_TYING_H

#include <functional>
#include <optional>
#include <vector>

#include "core/mapping/closure_candidates.h"
#include "core/mapping/place_shelf.h"
#include "core/mapping/scan_graph.h"
#include "core/mapping/way_search.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// Of where odometry has a place: where it may be anywhere about, that one of the places looks like
/// what should be there is worth no more than any other sighting. [m]
constexpr double kTrackSigma = 1.0;

/// A scan's grid, about the middle of what it shows and its axes along the map's, and where the
/// robot is thought to have stood.
struct LaidScan {
  EvidenceGrid grid;
  Pose2d grid_from_base;
  Pose2d map_from_base;
  std::optional<double> compass;  ///< that it showed [rad]
};

/// Ties scans to places by where their grids align.
class ScanTying {
 public:
  /// Keeps references to graph and shelf.
  ScanTying(ScanGraph& graph, PlaceShelf& shelf, const SonarModelOptions& sonar, double cell_size)
      : graph_(graph), shelf_(shelf), sonar_(sonar), geometry_{cell_size} {}

  /// Lays a node's readings out where it would stand at `map_from_base`.
  LaidScan lay(NodeIndex node, const Pose2d& map_from_base) const;

  /// Where the fits of a scan put the robot. By how much the compass errs is bound to the place: a
  /// fit by which it would err otherwise than it did there is hardly probable.
  std::vector<Sighting> sightings(const std::vector<PlaceFit>& fits, const LaidScan& scan) const;

  /// Whether one of the fits is where the robot is thought to be, as far as odometry can tell since
  /// it was at that place; then the scan is tied to the places about. `closure`: on which closure
  /// all of this rests, 0: none.
  /// `ways`: from the node; `most_sigma`: how well it is known where any place is, however long the
  /// way to it, or none [m]. `near_only`: only a fit close by is one, however sure another is.
  bool track(NodeIndex node, const LaidScan& scan, const std::vector<PlaceFit>& fits,
             WaySearch& ways, double most_sigma, bool near_only, int closure);

  /// Ties the node to a place where that aligns within `near` [m] of where the robot is thought to
  /// be; `window` is how far the heading may be off [rad].
  bool tie(PlaceId id, NodeIndex node, const LaidScan& scan, double near, double window,
           int closure);

 private:
  /// How well it is known where a place is [m].
  using SigmaTo = std::function<double(PlaceId)>;

  /// Where the robot is, if one of the sightings is where it is thought to be; as odometry has it,
  /// or as a sighting does that is expected there.
  std::optional<Pose2d> whereTracked(NodeIndex node, const LaidScan& scan,
                                     const std::vector<Sighting>& seen, WaySearch& ways,
                                     const SigmaTo& sigma_to, bool near_only) const;

  ScanGraph& graph_;
  PlaceShelf& shelf_;
  SonarModel sonar_;
  GridGeometry geometry_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_SCAN_TYING_H
