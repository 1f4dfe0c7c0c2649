#ifndef PLACE_MEMORY_TRAINING_CALIBRATION_FIT_H
#define PLACE_MEMORY_TRAINING_CALIBRATION_FIT_H

#include <optional>
#include <vector>

#include "place_memory/core/calibration.h"
#include "place_memory/core/rescoring_weights.h"
#include "training/candidates.h"

namespace place_memory::training {

/// By what places are ranked.
struct RankingWeights {
  Features metric = Features::Zero();
  std::optional<core::RescoringWeights> rescoring;
};

/// Fits the calibration by logistic regression. `known` are scans at learned places, `strangers`
/// scans at places that are not; both sides weigh the same, however many they are.
core::Calibration fitCalibration(const std::vector<CandidateList>& known,
                                 const std::vector<CandidateList>& strangers,
                                 const RankingWeights& weights);

/// What the calibration says of scans it was not fitted on.
struct CalibrationReport {
  double recognized = 0.0;         ///< share of the known scans that are RECOGNIZED and right
  double wrong = 0.0;              ///< share of the known scans that are RECOGNIZED and wrong
  double accepted = 0.0;           ///< share of the strangers that are RECOGNIZED
  double missed = 0.0;             ///< share of the known scans that are UNKNOWN
  double refused = 0.0;            ///< share of the strangers that are UNKNOWN
  double top_one = 0.0;            ///< share of the known scans whose best match is right
  double calibration_error = 0.0;  ///< expected, over ten bins, both sides weighing the same
};

CalibrationReport reportCalibration(const std::vector<CandidateList>& known,
                                    const std::vector<CandidateList>& strangers,
                                    const RankingWeights& weights,
                                    const core::Calibration& calibration, double confidence);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_CALIBRATION_FIT_H
