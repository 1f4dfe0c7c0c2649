#ifndef PLACE_MEMORY_CORE_RECOGNIZE_VERDICT_H
#define PLACE_MEMORY_CORE_RECOGNIZE_VERDICT_H

#include <cstddef>

#include "core/match/pair_counts.h"
#include "core/recognize/hypothesis_cluster.h"
#include "core/recognize/scan_query.h"
#include "place_memory/core/calibration.h"
#include "place_memory/core/recognition.h"

namespace place_memory::core {

/// `counts`: at the best alignment; `own`: the pairs of the scan with itself. Shares are 0 where
/// there is no such cell.
CalibrationFeatures calibrationFeatures(const AlignmentCounts& counts, const PairCounts& own,
                                        const HypothesisCluster& cluster, std::size_t places,
                                        double scale);

/// Sets the probabilities of the matches, which are ranked, and the verdict: RECOGNIZED where the
/// best has at least `confidence`; AMBIGUOUS where only all places together have it; else UNKNOWN.
void judge(const CalibrationFeatures& features, const Calibration& calibration, double confidence,
           Recognition& recognition);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_VERDICT_H
