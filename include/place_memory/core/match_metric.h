#ifndef PLACE_MEMORY_CORE_MATCH_METRIC_H
#define PLACE_MEMORY_CORE_MATCH_METRIC_H

#include <array>
#include <cstddef>

namespace place_memory::core {

/// A cell's class, told by the sign of its evidence (paper 4).
enum class CellClass { kEmpty = 0, kUnsensed = 1, kOccupied = 2 };
constexpr std::size_t kCellClasses = 3;

/// Points for a pair of corresponding cells, by the class of each: `weights[recognition][learned]`.
using PairWeights = std::array<std::array<double, kCellClasses>, kCellClasses>;

/// The paper's match metric: one point for each pair of the same class (paper 4).
constexpr PairWeights kPaperWeights{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

/// What an alignment scores: the points of all pairs of corresponding cells (paper 4), less what
/// transforms cost that are far from where the robot is expected to stand.
struct MatchMetric {
  PairWeights weights = kPaperWeights;
  double shift_cost = 0.0;  ///< for each square metre of shift [points / m^2], >= 0
  /// For a rotation to the edge of the heading window, growing with its square [points], >= 0. Free
  /// where every heading is sought.
  double rotation_cost = 0.0;
  /// Pairs are those of cells where the moved recognition grid and the learned one overlap, as
  /// transforms of the one are mostly understood. Else the recognition grid is unsensed beyond its
  /// rim, every learned cell is one of a pair, and a shift by itself costs no points.
  bool overlap_only = false;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_METRIC_H
