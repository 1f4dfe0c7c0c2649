#ifndef PLACE_MEMORY_CORE_RECOGNITION_H
#define PLACE_MEMORY_CORE_RECOGNITION_H

#include <array>
#include <cstddef>
#include <vector>

#include "place_memory/core/place_id.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

enum class Verdict {
  kUnknown,     ///< no place is sure to fit, or there is none
  kAmbiguous,   ///< one of the places, but which is not sure
  kRecognized,  ///< the best match is the place
};

/// "unknown", "ambiguous" or "recognized", as tables have it.
constexpr const char* nameOf(Verdict verdict) {
  constexpr std::array<const char*, 3> kNames{"unknown", "ambiguous", "recognized"};
  return kNames[static_cast<std::size_t>(verdict)];
}

/// How well one place fits a scan.
struct PlaceMatch {
  PlaceId id = kNoPlace;
  double score = 0.0;        ///< at the alignment; higher is better
  Pose2d place_from_scan;    ///< the alignment: pose of the scan frame in the place's grid
  double probability = 0.0;  ///< that this is the place, in [0, 1]; over all matches <= 1
};

/// The answer to one scan.
struct Recognition {
  Verdict verdict = Verdict::kUnknown;
  /// No echo lies in the scan's grid, so that it tells nothing of where it was taken: UNKNOWN, and
  /// no place is probable.
  bool no_echo = false;
  /// Every place, of more than 1024 the best of them: the chosen one first, the others by falling
  /// score; equal scores: lower id first.
  std::vector<PlaceMatch> matches;
  /// Robot's base at the end of the scan, in the map frame, by the best match (paper 9); identity
  /// where there is no match.
  Pose2d map_from_robot;
  /// Of map_from_robot: row-major 3 x 3 over x [m], y [m], yaw [rad].
  std::array<double, 9> covariance{};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNITION_H
