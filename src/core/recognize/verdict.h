#ifndef PLACE_MEMORY_CORE_RECOGNIZE_VERDICT_H
#define PLACE_MEMORY_CORE_RECOGNIZE_VERDICT_H

#include <array>
#include <cstddef>

#include "core/match/pair_metric.h"
#include "core/recognize/consensus.h"
#include "core/recognize/second_look.h"
#include "place_memory/core/recognition.h"

namespace place_memory::core {

/// What speaks for the best match and against it, as the calibration's coefficients take it. Names
/// of coefficients in preset files.
constexpr std::array<const char*, 15> kSupportNames{
    "bias",                  // 1
    "empty_on_empty",        // share of the scan's empty cells that fall on learned empty ones
    "empty_on_occupied",     // likewise on occupied ones
    "occupied_on_empty",     // share of the scan's occupied cells that fall on learned empty ones
    "occupied_on_occupied",  // likewise on occupied ones
    "occupied_within_one",   // likewise up to one cell from occupied ones
    "occupied_within_two",   // up to two cells
    "empty_by_occupied",     // share of the empty cells up to one cell from learned occupied ones
    "learned_occupied_on_empty",     // share of the learned occupied cells on which empty ones fall
    "learned_occupied_on_occupied",  // likewise occupied ones
    "learned_empty_on_occupied",     // share of the learned empty cells on which occupied ones fall
    "lead",                          // log(1 + scale * Consensus::lead)
    "prominence",                    // scale * Consensus::prominence
    "uncontested",                   // scale * Consensus::uncontested
    "fewness",                       // 1 / number of places: a lead over few says little
};
using Support = std::array<double, kSupportNames.size()>;

/// `at` and `closely`: the counts at the best alignment; `own`: the pairs of the scan with itself.
/// Shares are 0 where there is no such cell.
Support supportOf(const PairCounts& at, const CloseCounts& closely, const PairCounts& own,
                  const Consensus& consensus, std::size_t places, double scale);

/// From scores to probabilities. Log odds are the sum of coefficients times support. What the
/// probability that the scan is of a known place exceeds that of the best match by goes to the
/// other places, in proportion to exp(scale * score), but to none more than the best has.
struct Calibration {
  double scale = 1.0;  ///< [1 / score], > 0
  /// Of the log odds that the best match is right.
  Support right{-6.0, 2.0, -5.0, -5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  /// Of those that the scan is of any place of the memory.
  Support known{-4.0, 2.0, -5.0, -5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  /// How sharply a pose's likelihood falls with its score, for the pose's covariance [1 / score],
  /// >= 0.
  double sharpness = 0.1;
};

/// Sets the probabilities of the matches, which are ranked, and the verdict: RECOGNIZED where the
/// best has at least `confidence`; AMBIGUOUS where only all places together have it; else UNKNOWN.
void judge(const Support& support, const Calibration& calibration, double confidence,
           Recognition& recognition);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_VERDICT_H
