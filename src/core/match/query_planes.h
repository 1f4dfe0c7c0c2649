#ifndef PLACE_MEMORY_CORE_MATCH_QUERY_PLANES_H
#define PLACE_MEMORY_CORE_MATCH_QUERY_PLANES_H

#include <vector>

#include "core/grid/cell_planes.h"
#include "core/grid/cell_shift.h"
#include "core/match/pair_counts.h"

namespace place_memory::core {

/// A grid rotated about its centre. Each cell takes the class of the cell whose centre's
/// neighbourhood its own centre falls in when rotated back by `angle` [rad] (paper 4); cells that
/// the rotation brings in from outside are unsensed.
CellPlanes rotated(const CellPlanes& grid, double angle);

/// Pairs of corresponding cells of a rotated and then shifted recognition grid and a learned grid,
/// by class: one pair for each cell of the learned grid. Where the recognition grid does not reach
/// it is unsensed. Shifts in [-63, 63].
PairCounts countPairs(const CellPlanes& recognition, CellShift shift, const CellPlanes& learned);

/// Likewise, but for the learned cells alone that the recognition grid reaches: those of
/// QueryPlanes::reach(), shifted.
PairCounts countOverlap(const CellPlanes& recognition, const BitPlane& reach, CellShift shift,
                        const CellPlanes& learned);

/// The recognition grid at every heading of a search, made once and used for every place.
class QueryPlanes {
 public:
  /// Headings are multiples of `heading_step` [rad], from -`rotations` to +`rotations` of them.
  QueryPlanes(const EvidenceGrid& grid, double heading_step, int rotations);

  int rotations() const { return rotations_; }
  double headingStep() const { return heading_step_; }
  /// Rotation in [-rotations(), rotations()].
  const CellPlanes& at(int rotation) const {
    const int index = rotation + rotations_;
    return planes_[static_cast<std::size_t>(index)];
  }
  /// The cells that the rotated grid covers.
  BitPlane reach(int rotation) const;

 private:
  double heading_step_;
  int rotations_;
  std::vector<CellPlanes> planes_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_QUERY_PLANES_H
