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

/// A part of what a calibration is fitted on. Either side weighs so much, however many they are.
struct CalibrationScans {
  std::vector<CandidateList> known;      ///< scans at learned places
  std::vector<CandidateList> strangers;  ///< scans at places that are not
  double known_weight = 1.0;
  double strangers_weight = 1.0;
};

/// Fits the calibration by logistic regression. Scores are scaled by the first part.
core::Calibration fitCalibration(const std::vector<CalibrationScans>& parts,
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
