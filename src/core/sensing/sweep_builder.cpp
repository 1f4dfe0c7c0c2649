#include "core/sensing/sweep_builder.h"

#include <algorithm>
#include <atomic>

#include "core/sensing/odometry_jump.h"
#include "core/sensing/scan_echoes.h"

namespace place_memory::core {
namespace {

constexpr std::chrono::nanoseconds kLongestGap = std::chrono::seconds(2);

}  // namespace

std::uint64_t newScanId() {
  static std::atomic<std::uint64_t> newest{0};
  return ++newest;
}

Scan makeScan(const std::vector<LocatedReading>& readings, const Pose2d& fixed_from_scan,
              const Pose2d& fixed_from_base, const SonarModel& model, GridGeometry geometry) {
  const Pose2d scan_from_fixed = fixed_from_scan.inverse();
  Scan scan;
  scan.readings.reserve(readings.size());
  scan.sensors.reserve(readings.size());
  for (const LocatedReading& located : readings) {
    SonarReading& reading = scan.readings.emplace_back(located.reading);
    reading.sensor_pose = scan_from_fixed * reading.sensor_pose;
    scan.sensors.push_back(located.sensor);
  }
  scan.grid = model.build(scan.readings, geometry);
  scan.echoes = countEchoes(scan.readings, geometry);
  scan.odom_from_scan = fixed_from_scan;
  scan.robot_in_scan = scan_from_fixed * fixed_from_base;
  return scan;
}

SweepBuilder::Added SweepBuilder::add(const LocatedReading& reading) {
  if (full()) return Added::kFull;
  std::chrono::nanoseconds gap{0};
  if (!readings_.empty()) {
    const LocatedReading& last = readings_.back();
    gap = std::chrono::abs(reading.stamp - last.stamp);
    const double seconds = std::chrono::duration<double>(gap).count();
    if (odometry_ && odometryJumped(last.fixed_from_base, reading.fixed_from_base, seconds)) {
      return Added::kJumped;
    }
  }
  coverage_.add(reading.sensor, reading.fixed_from_base.yaw);
  longest_gap_ = std::max(longest_gap_, std::min(gap, kLongestGap));
  readings_.push_back(reading);
  return Added::kUsed;
}

Scan SweepBuilder::scan(double compass_offset, const Pose2d& fixed_from_base,
                        const SonarModel& model, GridGeometry geometry) const {
  const Pose2d& origin = readings_.front().fixed_from_base;
  Scan scan =
      makeScan(readings_, {origin.x, origin.y, -compass_offset}, fixed_from_base, model, geometry);
  if (!odometry_) scan.odom_from_scan = {};
  return scan;
}

}  // namespace place_memory::core
