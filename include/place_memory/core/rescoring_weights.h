#ifndef PLACE_MEMORY_CORE_RESCORING_WEIGHTS_H
#define PLACE_MEMORY_CORE_RESCORING_WEIGHTS_H

#include <array>
#include <cstddef>

#include "place_memory/core/match_metric.h"

namespace place_memory::core {

/// Pairs of cells of the two grids that lie near one another: along rows, columns and diagonally.
enum class NearPairs : std::size_t {
  kOccupiedWithinOne,         ///< the scan's occupied cells up to one cell from learned ones
  kOccupiedWithinTwo,         ///< up to two cells
  kLearnedOccupiedWithinOne,  ///< learned occupied cells up to one cell from the scan's
  kLearnedOccupiedWithinTwo,  ///< up to two cells
  kWithinOneOfBoth,           ///< any cells up to one cell from occupied ones of both
  kEmptyByOccupied,           ///< the scan's empty cells up to one cell from learned occupied ones
  kOccupiedByEmpty,           ///< learned empty cells up to one cell from the scan's occupied ones
};
constexpr std::size_t kNearPairs = 7;
/// Their names in preset files.
constexpr std::array<const char*, kNearPairs> kNearPairsNames{"occupied_within_one",
                                                              "occupied_within_two",
                                                              "learned_occupied_within_one",
                                                              "learned_occupied_within_two",
                                                              "within_one_of_both",
                                                              "empty_by_occupied",
                                                              "occupied_by_empty"};

/// Re-scoring: a richer metric for the few places that the search ranks first. An echo a cell off,
/// which the search's metric calls a contradiction, is nearly as good as one in its place.
struct RescoringWeights {
  double search_score = 1.0;  ///< of what the search's metric says
  PairWeights inner{};        ///< of pairs up to nine cells from the place
  PairWeights middle{};       ///< of pairs from there to seventeen cells
  std::array<double, kNearPairs> near{};
  /// Of the peak's sharpness: by how much the search's score changes beside the alignment.
  double peak_sharpness_shift = 0.0;     ///< by a shift of two cells
  double peak_sharpness_rotation = 0.0;  ///< by a rotation of two heading steps
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RESCORING_WEIGHTS_H
