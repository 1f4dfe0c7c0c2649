#ifndef PLACE_MEMORY_TRAINING_SPARSE_LISTS_H
#define PLACE_MEMORY_TRAINING_SPARSE_LISTS_H

#include <cstdint>
#include <vector>

#include "training/calibration_fit.h"
#include "trials/sparse_trials.h"

namespace place_memory::training {

/// Places this near to a scan are what it could rightly be recognized as [m].
constexpr double kStrangerDistance = 2.5;

/// trials::simulateSparse(), matched: its scans, those of elsewhere, and once more its own without
/// the places that are near.
CalibrationScans alignSparse(trials::SparseKind kind, std::uint64_t seed,
                             const core::SonarModel& model, const core::MatchMetric& metric);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_SPARSE_LISTS_H
