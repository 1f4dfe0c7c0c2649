#ifndef PLACE_MEMORY_CORE_VERDICT_H
#define PLACE_MEMORY_CORE_VERDICT_H

#include <array>

#include "place_memory/core/pair_metric.h"
#include "place_memory/core/recognition.h"

namespace place_memory::core {

/// Of the scan's empty and occupied cells (rows), the shares that fall on empty and on occupied
/// cells of the learned grid (columns); each in [0, 1], 0 where the scan has no such cell.
using Agreement = std::array<std::array<double, 2>, 2>;

/// `at`: the pairs at the alignment; `own`: those of the scan with itself.
Agreement agreementOf(const PairCounts& at, const PairCounts& own);

/// From scores to probabilities. The log odds that the best match is right are
///   bias + sum of agreement * shares + margin * log(1 + scale * (best - runner-up)).
/// What is left of the probability goes by `others` to the other places, in proportion to
/// exp(scale * score).
struct Calibration {
  double scale = 1.0;  ///< [1 / score], > 0
  double bias = -6.0;
  Agreement shares{{{2.0, -5.0}, {-5.0, 5.0}}};
  double margin = 1.0;  ///< >= 0
  double others = 0.5;  ///< share, in [0, 1]
  /// How sharply a pose's likelihood falls with its score, for the pose's covariance [1 / score],
  /// >= 0.
  double sharpness = 0.1;
};

/// Sets the probabilities of the matches, which are ranked, and the verdict: RECOGNIZED where the
/// best has at least `confidence`; AMBIGUOUS where it would have it if the runner-up scored
/// nothing; else UNKNOWN. `agreement` is that of the best match, `lead` what it scores above the
/// best one that contradicts it.
void judge(const Agreement& agreement, double lead, const Calibration& calibration,
           double confidence, Recognition& recognition);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_VERDICT_H
