#ifndef PLACE_MEMORY_CORE_MATCH_LINEAR_METRIC_H
#define PLACE_MEMORY_CORE_MATCH_LINEAR_METRIC_H

#include "core/match/pair_counts.h"

namespace place_memory::core {

/// PairWeights by what has to be counted. All nine counts of pairs follow from the four of sensed
/// cells on sensed ones and from how many cells each grid has of each class, so a score is
///   the points of those four + those of the recognition grid's cells that fall on the learned grid
///   + those of the learned grid's cells + unsensed.
struct LinearMetric {
  explicit LinearMetric(const PairWeights& weights);

  double occupied_occupied, occupied_empty;  ///< a pair, the recognition grid's cell named first
  double empty_occupied, empty_empty;
  double occupied, empty;                  ///< a cell of the recognition grid
  double learned_occupied, learned_empty;  ///< a cell of the learned grid
  double unsensed;                         ///< of two grids that sensed nothing
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_LINEAR_METRIC_H
