#ifndef PLACE_MEMORY_TRIALS_EPISODE_FILE_H
#define PLACE_MEMORY_TRIALS_EPISODE_FILE_H

#include <string>

#include "trials/trial_set.h"

namespace place_memory::trials {

/// Reads recorded scans: JSON lines, gzipped where the name ends in .gz, one scan a line, with
///   role "learn" or "recognize"; place, its label, for a learn line; accept, the labels that are
///   right, for a recognize line; pose [x m, y m, yaw rad] of the base in the map as the scan
///   began; compass, its error [rad]; any_heading, true where the compass says nothing; ring_radius
///   [m]; fov [rad], r_min, r_max [m] of every sensor; cell, the cell size that suits it [m];
///   readings, each [set, bearing of the sensor rad, turn of the base since the start rad, range m
///   or null for no echo]; and of a recognize line, where the lines follow a drive, way, the poses
///   since the one before, its own the last. Ranges outside [r_min, r_max] are left out; one
///   reading at least must remain. No place is learned twice, and whatever a line accepts is
///   learned.
/// Throws std::runtime_error naming the file, the line, the field and what is wrong with it.
TrialSet readEpisodeFile(const std::string& path);

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_EPISODE_FILE_H
