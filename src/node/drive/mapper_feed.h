#ifndef PLACE_MEMORY_NODE_DRIVE_MAPPER_FEED_H
#define PLACE_MEMORY_NODE_DRIVE_MAPPER_FEED_H

#include <chrono>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/mapping/mapper.h"
#include "node/drive/drive_feed.h"

namespace place_memory::node {

/// Where odometry has the base.
struct OdometryMoment {
  std::chrono::nanoseconds stamp{0};
  core::Pose2d odom_from_base;
};

/// Feeds a mapper, and has it begin a session where odometry started anew.
class MapperFeed : public DriveListener {
 public:
  /// What came of the drive up to a pose of odometry; `jumped`: it started anew just before.
  using Step = std::function<void(const OdometryMoment& now, bool jumped)>;

  /// A reading that the mapper gets, in the base's frame, and where odometry had that.
  using Heard = std::function<void(const core::Pose2d& odom_from_base, const core::SonarReading&)>;

  /// `mapper` must outlive it; `heard` may be null.
  MapperFeed(core::Mapper& mapper, Step step, Heard heard = nullptr)
      : mapper_(mapper), step_(std::move(step)), heard_(std::move(heard)) {}

  void onHeading(std::chrono::nanoseconds stamp, double yaw) override;
  void onReading(std::chrono::nanoseconds stamp, const core::Pose2d& odom_from_base,
                 const core::SonarReading& reading) override;
  void onOdometry(std::chrono::nanoseconds stamp, const core::Pose2d& odom_from_base) override;

  /// Time has jumped, or the robot was carried: a session begins.
  void restart();
  /// The newest pose of odometry that the mapper has.
  const std::optional<OdometryMoment>& newest() const { return newest_; }

 private:
  struct Reading {
    std::chrono::nanoseconds stamp;
    core::Pose2d odom_from_base;
    core::SonarReading reading;
  };

  core::Mapper& mapper_;
  Step step_;
  Heard heard_;
  std::vector<std::pair<std::chrono::nanoseconds, double>> headings_;  // since the newest odometry
  std::vector<Reading> readings_;                                      // likewise
  std::optional<OdometryMoment> newest_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_DRIVE_MAPPER_FEED_H
