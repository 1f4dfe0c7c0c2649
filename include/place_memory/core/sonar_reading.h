#ifndef PLACE_MEMORY_CORE_SONAR_READING_H
#define PLACE_MEMORY_CORE_SONAR_READING_H

#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// What does not change from one reading of a sonar to the next.
struct SonarSpec {
  double field_of_view = 0.0;  ///< full opening angle of the cone [rad], in (0, pi]
  double min_range = 0.0;      ///< [m], >= 0
  double max_range = 0.0;      ///< [m], > min_range

  bool operator==(const SonarSpec& other) const {
    return field_of_view == other.field_of_view && min_range == other.min_range &&
           max_range == other.max_range;
  }
};

/// One echo, or the lack of one, already checked against REP 117 and the sensor's limits.
struct SonarReading {
  /// Position of the sensor and direction of its axis in the scan frame: origin where the robot's
  /// base stood when the scan began, x axis along compass east.
  Pose2d sensor_pose;
  SonarSpec spec;
  /// [m]; in [min_range, max_range], or +infinity where no echo came back.
  double range = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SONAR_READING_H
