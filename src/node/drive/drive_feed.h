#ifndef PLACE_MEMORY_NODE_DRIVE_DRIVE_FEED_H
#define PLACE_MEMORY_NODE_DRIVE_DRIVE_FEED_H

#include <tf2/buffer_core.h>

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "core/sensing/heading_history.h"
#include "node/drive/drive_moment.h"
#include "node/input/message_intake.h"
#include "node/input/reject.h"
#include "node/scan/reading_locator.h"

namespace place_memory::node {

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

/// What of a drive was used, and what could not be.
struct DriveLosses {
  std::size_t readings = 0;  ///< that were used
  RejectCounts rejected{};
  std::string problem;  ///< why the newest of them was left out, in a sentence, where there is more
                        ///< to say
};

/// The moments of what a message says. What cannot be used is counted.
std::vector<DriveMoment> momentsOf(Taken taken, std::chrono::nanoseconds received,
                                   DriveLosses& losses);
DriveMoment momentOf(const geometry_msgs::TransformStamped& transform,
                     std::chrono::nanoseconds received);

/// Locates readings, each once odometry on both sides of its stamp is known, and hands everything
/// on: node and bag tool alike. What comes of it depends on the moments alone, and not on when they
/// come.
class DriveFeed {
 public:
  /// All must outlive it.
  DriveFeed(const config::Parameters& parameters, DriveLosses& losses, DriveListener& listener);

  void addStatic(const geometry_msgs::TransformStamped& transform);
  /// In the order of moments.
  void take(const DriveMoment& moment);
  /// Readings that still have no odometry after their stamp are lost.
  void end();
  /// Time has jumped: what came before says nothing of what comes.
  void restart();

 private:
  void take(std::chrono::nanoseconds stamp, const DrivenHeading& heading);
  void take(std::chrono::nanoseconds stamp, const core::Measurement& measurement);
  void take(std::chrono::nanoseconds stamp, const DrivenTransform& moved);
  void note(const std::optional<std::string>& problem);
  void reject(const ReadingLocator::Located& located);
  void release(std::chrono::nanoseconds until);

  std::chrono::nanoseconds wait_;
  tf2::BufferCore transforms_;
  core::HeadingHistory headings_;  // the locator's, which needs none: there is odometry
  ReadingLocator locator_;
  DriveLosses& losses_;
  DriveListener& listener_;
  std::deque<core::Measurement> waiting_;
  std::optional<std::chrono::nanoseconds> odometry_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_DRIVE_FEED_H
