#ifndef PLACE_MEMORY_TOOLS_DRIVE_READER_H
#define PLACE_MEMORY_TOOLS_DRIVE_READER_H

#include <chrono>
#include <functional>
#include <string>

#include "config/parameters.h"
#include "node/input/reject.h"
#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"
#include "tools/bag_scanner.h"
#include "tools/bag_set.h"

namespace place_memory::tools {

/// Who takes a drive, in the order of its stamps.
class DriveListener {
 public:
  virtual ~DriveListener() = default;

  /// A compass heading [rad].
  virtual void onHeading(std::chrono::nanoseconds stamp, double yaw) = 0;
  /// A reading in the base's frame, and where odometry has the base at its stamp.
  virtual void onReading(std::chrono::nanoseconds stamp, const core::Pose2d& odom_from_base,
                         const core::SonarReading& reading) = 0;
  /// Odometry's next pose; all readings and headings up to it have come.
  virtual void onOdometry(std::chrono::nanoseconds stamp, const core::Pose2d& odom_from_base) = 0;
};

/// What was in a bag and could not be used.
struct DriveLosses {
  std::size_t readings = 0;  ///< that were used
  node::RejectCounts rejected{};
  std::string problem;  ///< why the newest of them was left out, in a sentence, where there is more
                        ///< to say
};

/// Reads whole bags in the order of the stamps in its messages, whatever the order in which they
/// were recorded. A reading comes once odometry on both sides of its stamp is known.
///
/// `scanner`: of these bags. Throws std::exception where a bag is damaged, and where the parameters
/// name no odometry.
DriveLosses readDrive(const BagSet& bags, BagScanner& scanner, const config::Parameters& parameters,
                      DriveListener& listener);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_DRIVE_READER_H
