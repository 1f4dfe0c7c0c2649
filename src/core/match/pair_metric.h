#ifndef PLACE_MEMORY_CORE_MATCH_PAIR_METRIC_H
#define PLACE_MEMORY_CORE_MATCH_PAIR_METRIC_H

#include <array>
#include <cstddef>

namespace place_memory::core {

/// A cell's class, told by the sign of its evidence (paper 4).
enum class CellClass { kEmpty = 0, kUnsensed = 1, kOccupied = 2 };
constexpr std::size_t kCellClasses = 3;

/// How many pairs of corresponding cells have each class: `counts[recognition][learned]`.
using PairCounts = std::array<std::array<int, kCellClasses>, kCellClasses>;

/// Points for a pair of corresponding cells, by the class of each: `weights[recognition][learned]`.
using PairWeights = std::array<std::array<double, kCellClasses>, kCellClasses>;

/// The paper's match metric: one point for each pair of the same class (paper 4).
constexpr PairWeights kPaperWeights{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/// Sum of the points of all pairs.
inline double pairScore(const PairCounts& counts, const PairWeights& weights) {
  double score = 0.0;
  for (std::size_t r = 0; r < kCellClasses; ++r) {
    for (std::size_t l = 0; l < kCellClasses; ++l) score += counts[r][l] * weights[r][l];
  }
  return score;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_PAIR_METRIC_H
