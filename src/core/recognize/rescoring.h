#ifndef PLACE_MEMORY_CORE_RECOGNIZE_RESCORING_H
#define PLACE_MEMORY_CORE_RECOGNIZE_RESCORING_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/match/query_planes.h"
#include "core/recognize/peak_sharpness.h"
#include "place_memory/core/rescoring_weights.h"

namespace place_memory::core {

/// So many of the places that the search ranks first are re-scored.
constexpr std::size_t kRescored = 10;

/// What re-scoring counts at an alignment.
struct RescoringCounts {
  /// Pairs of corresponding cells up to nine cells from the place, which sonar sees best.
  PairCounts inner{};
  PairCounts middle{};  ///< likewise from there to seventeen cells
  std::array<int, kNearPairs> near{};

  int of(NearPairs pairs) const { return near[static_cast<std::size_t>(pairs)]; }
};

/// Of a rotated and then shifted recognition grid and a learned grid. Shifts in [-63, 63].
RescoringCounts countForRescoring(const CellPlanes& recognition, CellShift shift,
                                  const CellPlanes& learned);

/// The re-scoring score of a place.
double rescore(double search_score, const RescoringCounts& counts, const PeakSharpness& sharpness,
               const RescoringWeights& weights);

/// The scores by which all places are ranked, of which `search` are the search's, falling, and
/// `rescored` the re-scoring's of the foremost of them: the others keep their distance to the last
/// one that was re-scored, and do not pass the least re-scoring score. `rescored` is not empty.
std::vector<double> combineScores(const std::vector<double>& search,
                                  const std::vector<double>& rescored);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_RESCORING_H
