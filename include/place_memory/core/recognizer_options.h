#ifndef PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H
#define PLACE_MEMORY_CORE_RECOGNIZER_OPTIONS_H

#include <optional>

#include "core/match/match_metric.h"
#include "core/recognize/second_look.h"
#include "core/recognize/verdict.h"
#include "place_memory/core/search_method.h"

namespace place_memory::core {

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
