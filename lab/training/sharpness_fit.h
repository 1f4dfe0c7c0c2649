#ifndef PLACE_MEMORY_TRAINING_SHARPNESS_FIT_H
#define PLACE_MEMORY_TRAINING_SHARPNESS_FIT_H

#include <vector>

#include "place_memory/core/match_metric.h"
#include "place_memory/core/sonar_model.h"
#include "trials/trial_set.h"

namespace place_memory::training {

/// The sharpness (see core::Calibration) at which poses are as far from the truth as their
/// covariance says: each scan is aligned with the place that is right, and the mean of the
/// normalised squared errors is brought nearest to 3, the number of coordinates. Alignments that
/// are wrong altogether do not count, nor sets of robots that misjudge their turns: how far off
/// those are the scores do not tell.
/// @throws std::runtime_error where nothing is left.
double fitSharpness(const std::vector<trials::TrialSet>& sets, const core::SonarModel& model,
                    const core::MatchMetric& metric);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_SHARPNESS_FIT_H
