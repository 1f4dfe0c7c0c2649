#ifndef PLACE_MEMORY_CORE_MATCH_LATTICE_H
#define PLACE_MEMORY_CORE_MATCH_LATTICE_H

#include "core/grid/heading_step.h"
#include "place_memory/core/match_metric.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// The transforms that are searched: shifts by whole cells, rotations by whole heading steps.
struct SearchWindow {
  int cells = 0;          ///< shifts along x and y in [-cells, cells]
  int rotations = 0;      ///< rotations in [-rotations, rotations]
  bool circular = false;  ///< every heading is searched: `rotations` is `-rotations` once more

  /// Brings a rotation that left a circular window by one end, by less than a full one, back in by
  /// the other.
  int wrapped(int rotation) const {
    if (!circular) return rotation;
    return rotation > rotations    ? rotation - 2 * rotations
           : rotation < -rotations ? rotation + 2 * rotations
                                   : rotation;
  }
};

/// The least window that holds every shift up to `position_window` [m] along x and y and every
/// rotation up to `heading_window` [rad]; circular where that is pi.
SearchWindow searchWindow(double position_window, double heading_window, double cell_size);

/// A MatchMetric on the lattice of one search.
struct LatticeMetric {
  PairWeights weights = kPaperWeights;
  double shift_cost = 0.0;     ///< [points / cell^2]
  double rotation_cost = 0.0;  ///< [points / heading step^2]
  bool overlap_only = false;
};

LatticeMetric onLattice(const MatchMetric& metric, const SearchWindow& window, double cell_size);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_LATTICE_H
