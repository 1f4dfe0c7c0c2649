#ifndef PLACE_MEMORY_TRAINING_PRESET_FILE_H
#define PLACE_MEMORY_TRAINING_PRESET_FILE_H

#include <string>

#include "place_memory/config/match_preset.h"

namespace place_memory::training {

/// Writes a preset laid out as config/presets/*.yaml; `origin`, one line, says where it comes from.
/// Throws std::runtime_error where the file cannot be written.
void writePreset(const std::string& path, const std::string& origin,
                 const config::MatchPreset& preset);

}  // namespace place_memory::training

#endif  // PLACE_MEMORY_TRAINING_PRESET_FILE_H
