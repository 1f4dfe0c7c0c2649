#ifndef PLACE_MEMORY_CORE_MATCH_PAIR_COUNTS_H
#define PLACE_MEMORY_CORE_MATCH_PAIR_COUNTS_H

#include <array>
#include <cstddef>

#include "place_memory/core/match_metric.h"

namespace place_memory::core {

/// How many pairs of corresponding cells have each class: `counts[recognition][learned]`.
using PairCounts = std::array<std::array<int, kCellClasses>, kCellClasses>;

/// Sum of the points of all pairs.
inline double pairScore(const PairCounts& counts, const PairWeights& weights) {
  double score = 0.0;
  for (std::size_t r = 0; r < kCellClasses; ++r) {
    for (std::size_t l = 0; l < kCellClasses; ++l) score += counts[r][l] * weights[r][l];
  }
  return score;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_PAIR_COUNTS_H
