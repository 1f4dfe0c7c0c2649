#include "node/drive/mapper_feed.h"

#include <algorithm>
#include <cmath>

namespace place_memory::node {
namespace {

using std::chrono::nanoseconds;

// No robot that maps by sonars drives or turns faster: odometry started anew, or was set.
constexpr double kFastest = 5.0;       // [m/s]
constexpr double kLeastJump = 0.5;     // [m]
constexpr double kFastestTurn = 10.0;  // [rad/s]
constexpr double kLeastTurn = 1.0;     // [rad]

bool jumps(const OdometryMoment& from, const OdometryMoment& to) {
  const core::Pose2d motion = from.odom_from_base.inverse() * to.odom_from_base;
  const double seconds = std::chrono::duration<double>(to.stamp - from.stamp).count();
  return std::hypot(motion.x, motion.y) > std::max(kLeastJump, kFastest * seconds) ||
         std::abs(motion.yaw) > std::max(kLeastTurn, kFastestTurn * seconds);
}

}  // namespace

void MapperFeed::onHeading(nanoseconds stamp, double yaw) { headings_.emplace_back(stamp, yaw); }

void MapperFeed::onReading(nanoseconds stamp, const core::Pose2d& odom_from_base,
                           const core::SonarReading& reading) {
  readings_.push_back({stamp, odom_from_base, reading});
}

// What lies between two poses of which one jumped has no pose: it is left out.
void MapperFeed::onOdometry(nanoseconds stamp, const core::Pose2d& odom_from_base) {
  const OdometryMoment now{stamp, odom_from_base};
  const bool jumped = newest_ && jumps(*newest_, now);
  if (jumped) {
    mapper_.beginSession();
    readings_.clear();
  }
  for (const auto& [heading_stamp, yaw] : headings_) mapper_.addHeading(heading_stamp, yaw);
  headings_.clear();
  for (const Reading& reading : readings_) {
    mapper_.addReading(reading.stamp, reading.odom_from_base, reading.reading);
    if (heard_) heard_(reading.odom_from_base, reading.reading);
  }
  readings_.clear();
  mapper_.addOdometry(stamp, odom_from_base);
  newest_ = now;
  step_(now, jumped);
}

void MapperFeed::restart() {
  headings_.clear();
  readings_.clear();
  newest_.reset();
  mapper_.beginSession();
}

}  // namespace place_memory::node
