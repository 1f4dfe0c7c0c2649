#ifndef PLACE_MEMORY_CONFIG_MATCH_PRESET_H
#define PLACE_MEMORY_CONFIG_MATCH_PRESET_H

#include <optional>
#include <string>

#include "place_memory/config/parameter_error.h"
#include "place_memory/core/recognizer_options.h"
#include "place_memory/export.h"

namespace place_memory::config {

/// What was fitted together, and is chosen together by `match/preset`.
struct MatchPreset {
  core::MatchMetric metric;
  std::optional<core::RescoringWeights> rescoring;
  core::Calibration calibration;
};

/// A preset of the package by its name, `evidence` or `paper` (config/presets), otherwise that of
/// the file with this path. Throws ParameterError with everything that is wrong with the file.
PLACE_MEMORY_PUBLIC MatchPreset loadPreset(const std::string& name_or_path);

}  // namespace place_memory::config

#endif  // PLACE_MEMORY_CONFIG_MATCH_PRESET_H
