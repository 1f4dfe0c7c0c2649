#ifndef PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H
#define PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H

#include <optional>

#include "place_memory/core/match_metric.h"
#include "place_memory/core/second_look.h"
#include "place_memory/core/verdict.h"

namespace place_memory::core {

/// How the alignment of each place is sought.
enum class SearchMethod {
  kNearestNeighbour,  ///< no translation, no rotation: the paper's baseline (paper 5)
  kHillClimbing,      ///< multiresolution, one climb from the compass heading (paper 4)
  kRestarts,          ///< hill climbing from several headings and positions (paper 4, last lines)
  kExhaustive,        ///< every transform in the window: the oracle
};

struct RecognizerOptions {
  SearchMethod method = SearchMethod::kRestarts;
  MatchMetric metric;
  std::optional<SecondLook> second_look;  ///< at the places that score best; none: one look
  Calibration calibration;
  double position_window = 1.2;  ///< largest shift sought along x and along y [m], > 0
  double confidence = 0.82;      ///< probability from which a place is RECOGNIZED, in (0.5, 1)
  /// False: where places lie is not known, as without odometry, and says nothing of which of them
  /// put the robot at the same spot.
  bool located = true;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H
