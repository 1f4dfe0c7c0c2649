#ifndef PLACE_MEMORY_TRIALS_TRIAL_SET_H
#define PLACE_MEMORY_TRIALS_TRIAL_SET_H

#include <string>
#include <vector>

#include "place_memory/core/grid_geometry.h"
#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::trials {

/// A scan from which a place is learned.
struct LearnedScan {
  std::string label;
  /// True pose of the scan frame in the map: where the robot stood, and where compass east lay.
  core::Pose2d odom_from_scan;
  std::vector<core::SonarReading> readings;
};

/// A scan that is to be recognized (paper 5: a trial is one such scan against all learned grids).
struct RecognitionTrial {
  std::vector<std::string> accept;  ///< every label that is right; none: a place never learned
  core::Pose2d odom_from_scan;      ///< true pose, likewise
  double heading_window = 0.0;      ///< how far the compass may be off, in [0, pi] [rad]
  std::vector<core::SonarReading> readings;
  int round = 0;  ///< of several times that the robot comes back, from 0 on
  /// True poses of the base from the trial before to this one, which is the last; none: the trials
  /// are in no order.
  std::vector<core::Pose2d> way{};
};

/// One memory and the scans that are put to it.
struct TrialSet {
  std::string name;
  double cell_size = core::kDefaultCellSize;  ///< that suits the sensor [m]
  bool turns_truly = true;  ///< false: the robot misjudges its own turns, and its scans are bent
  std::vector<LearnedScan> learned;
  std::vector<RecognitionTrial> trials;
};

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_TRIAL_SET_H
