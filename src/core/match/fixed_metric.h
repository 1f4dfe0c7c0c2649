#ifndef PLACE_MEMORY_CORE_MATCH_FIXED_METRIC_H
#define PLACE_MEMORY_CORE_MATCH_FIXED_METRIC_H

#include <algorithm>
#include <cstdint>

#include "core/index/place_block.h"
#include "core/kernels/block_kernel.h"
#include "core/match/lattice.h"
#include "core/match/linear_metric.h"
#include "core/match/query_planes.h"

namespace place_memory::core {

/// How many pairs of cells of each kind a pair of coarse cells stands for.
struct PairShares {
  double occupied_occupied, occupied_empty;
  double empty_occupied, empty_empty;
};

/// A LatticeMetric in fixed point, so that sums do not depend on their order or on the processor: a
/// score is the points of pairs of sensed cells, plus what belongs to the transform, plus what
/// belongs to the place.
class FixedMetric {
 public:
  explicit FixedMetric(const LatticeMetric& metric);

  /// At most 2^30 where no share is above kMostShare.
  PairFactors factors(const PairShares& shares) const;
  static constexpr double kMostShare = 32.0;

  /// `inside`: cells of the recognition grid that lie on the learned grid after the shift.
  std::int64_t ofTransform(const CellTotals& inside, CellShift shift, int rotation) const {
    const int cells = shift.columns * shift.columns + shift.rows * shift.rows;
    return fixed(inside.occupied * linear_.occupied + inside.empty * linear_.empty -
                 metric_.shift_cost * cells - metric_.rotation_cost * rotation * rotation);
  }
  std::int64_t ofPlace(const CellTotals& learned) const;

 private:
  /// To the nearest, without a call of the library: a search has thousands of transforms.
  std::int64_t fixed(double points) const {
    constexpr double kMost = 1LL << 60;  // sums of three stay below 2^63
    const double scaled = std::clamp(points * scale_, -kMost, kMost);
    return static_cast<std::int64_t>(scaled + (scaled < 0.0 ? -0.5 : 0.5));
  }

  LatticeMetric metric_;
  LinearMetric linear_;
  double scale_ = 1.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_FIXED_METRIC_H
