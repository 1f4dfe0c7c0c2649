#ifndef PLACE_MEMORY_NODE_DRIVE_DRIVE_MOMENT_H
#define PLACE_MEMORY_NODE_DRIVE_DRIVE_MOMENT_H

#include <geometry_msgs/TransformStamped.h>

#include <chrono>
#include <string>
#include <variant>

#include "core/sensing/measurement.h"

namespace place_memory::node {

struct DrivenHeading {
  double yaw = 0.0;  ///< [rad]
};

struct DrivenTransform {
  geometry_msgs::TransformStamped transform;
  std::chrono::nanoseconds received{0};
};

/// What a message says of a drive, by the stamp in it.
struct DriveMoment {
  std::chrono::nanoseconds stamp{0};
  std::variant<DrivenHeading, core::Measurement, DrivenTransform> what;

  /// Of the sensor, or of the transform's child; empty for headings.
  const std::string& frame() const;
  /// By stamp. Of one stamp the transforms come last: all that is known of a moment is there when
  /// odometry has come to it. What else has one stamp is ordered by its frame, and not by which
  /// came first.
  bool operator<(const DriveMoment& other) const;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_DRIVE_MOMENT_H
