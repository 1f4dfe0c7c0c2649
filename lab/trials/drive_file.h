#ifndef PLACE_MEMORY_TRIALS_DRIVE_FILE_H
#define PLACE_MEMORY_TRIALS_DRIVE_FILE_H

#include <optional>
#include <string>
#include <vector>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::trials {

/// What the robot sensed at one time of a drive.
struct DriveMoment {
  double t = 0.0;                            ///< [s]
  core::Pose2d odom;                         ///< of the base
  std::optional<core::Pose2d> truth;         ///< likewise, in another frame
  std::optional<double> heading;             ///< of the compass [rad]
  std::vector<core::SonarReading> readings;  ///< in the base's frame
};

using Drive = std::vector<DriveMoment>;

/// Reads a drive: JSON lines, gzipped where the name ends in .gz, one moment a line, with t, odom,
/// truth (or null), heading (or none), fov, and readings, each [bearing, x, y, range or null for no
/// echo, maximum range]. Throws std::runtime_error naming the file, the line and what is wrong.
Drive readDriveFile(const std::string& path);

/// Writes one, as readDriveFile() reads it; gzipped where the name ends in .gz.
void writeDriveFile(const Drive& drive, const std::string& path);

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_DRIVE_FILE_H
