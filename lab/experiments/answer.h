#ifndef PLACE_MEMORY_EXPERIMENTS_ANSWER_H
#define PLACE_MEMORY_EXPERIMENTS_ANSWER_H

#include <cstdint>
#include <string>

#include "place_memory/core/recognition.h"

namespace place_memory::experiments {

/// What a method made of one trial.
struct Answer {
  std::uint64_t seed = 0;
  bool known = true;      ///< false: the place was never learned
  bool stranger = false;  ///< not known, and of another building
  bool right = false;     ///< the best match is the place; false for strangers
  std::string expected;
  std::string given;  ///< label of the best match
  core::Verdict verdict = core::Verdict::kUnknown;
  double probability = 0.0;  ///< of the best match
  int round = 0;             ///< of several times that the robot comes back, from 0 on
  bool folded = false;       ///< into the best match
  /// From the answered position to the true one, right or not [m]; NaN without a match.
  double distance = 0.0;
  /// Of the robot's pose by the best match [m], [rad]; NaN unless right.
  double position_error = 0.0;
  double heading_error = 0.0;
  /// Squared error of the pose over its covariance, three degrees of freedom; NaN unless right.
  double normalised_error = 0.0;
};

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_ANSWER_H
