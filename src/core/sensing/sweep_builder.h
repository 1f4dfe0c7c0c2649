#ifndef PLACE_MEMORY_CORE_SENSING_SWEEP_BUILDER_H
#define PLACE_MEMORY_CORE_SENSING_SWEEP_BUILDER_H

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "core/sensing/measurement.h"
#include "core/sensing/sweep_coverage.h"
#include "place_memory/core/scan.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::core {

/// Greater than 0, and given to no other scan of this process.
std::uint64_t newScanId();

/// The scan of readings whose frame has the pose `fixed_from_scan`; `fixed_from_base` is the
/// robot's when the scan ended. Its number and times are left to the caller.
Scan makeScan(const std::vector<LocatedReading>& readings, const Pose2d& fixed_from_scan,
              const Pose2d& fixed_from_base, const SonarModel& model, GridGeometry geometry);

/// Gathers the located readings of one sweep.
class SweepBuilder {
 public:
  static constexpr std::size_t kMaxReadings = 100000;

  enum class Added {
    kUsed,
    kFull,    ///< it holds as many readings as it may
    kJumped,  ///< odometry moved further since the reading before than a robot can
  };

  /// The first three as SweepCoverage has them. `odometry`: whether readings are located by it.
  SweepBuilder(int headings, double step, std::set<SensorId> sensors, bool odometry)
      : coverage_(headings, step, std::move(sensors)), odometry_(odometry) {}

  bool full() const { return readings_.size() >= kMaxReadings; }
  /// Only with kUsed the reading is one of the sweep.
  Added add(const LocatedReading& reading);
  /// A reading of the sensor came that cannot be used.
  void skip(SensorId sensor) { coverage_.skip(sensor); }

  const SweepCoverage& coverage() const { return coverage_; }
  const std::vector<LocatedReading>& readings() const { return readings_; }
  /// Between the stamps of one reading and the next, at most two seconds.
  std::chrono::nanoseconds longestGap() const { return longest_gap_; }

  /// The sweep as a scan, whose frame lies where the robot's base was at the first reading.
  /// `compass_offset`: by how much the compass reads more than the fixed frame's yaw [rad]. There
  /// must be a reading.
  Scan scan(double compass_offset, const Pose2d& fixed_from_base, const SonarModel& model,
            GridGeometry geometry) const;

 private:
  SweepCoverage coverage_;
  bool odometry_;
  std::vector<LocatedReading> readings_;
  std::chrono::nanoseconds longest_gap_{0};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_SWEEP_BUILDER_H
