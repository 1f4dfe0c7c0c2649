#ifndef PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H
#define PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H

#include <cstddef>
#include <optional>

#include "place_memory/core/calibration.h"
#include "place_memory/core/match_metric.h"
#include "place_memory/core/pose2d.h"
#include "place_memory/core/rescoring_weights.h"
#include "place_memory/core/search_method.h"

namespace place_memory::core {

/// The most threads that RecognizerOptions::threads may ask for.
constexpr std::size_t kMostThreads = 256;

struct RecognizerOptions {
  SearchMethod method = SearchMethod::kRestarts;
  MatchMetric metric;
  std::optional<RescoringWeights> rescoring;  ///< of the foremost places; none: the search's order
  Calibration calibration;
  double position_window = 1.2;  ///< largest shift sought along x and along y [m], > 0
  /// How far the compass may be off where a question does not say [rad], in [0, pi].
  double heading_window = kPi / 4.0;
  double confidence = 0.82;  ///< probability from which a place is RECOGNIZED, in (0.5, 1)
  /// False: where places lie is not known, as without odometry, and says nothing of which of them
  /// put the robot at the same spot.
  bool located = true;
  /// That match at a time, up to kMostThreads; 0: as many as the processor runs.
  std::size_t threads = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H
