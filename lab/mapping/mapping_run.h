#ifndef PLACE_MEMORY_MAPPING_MAPPING_RUN_H
#define PLACE_MEMORY_MAPPING_MAPPING_RUN_H

#include <chrono>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/mapping/mapper.h"
#include "trials/drive_file.h"

namespace place_memory::mapping {

/// The defaults of a robot.
core::MapperOptions mapperOptions();

/// Which part of a drive a mapper is fed, and how.
struct DrivePart {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
  bool compass = true;
  double start = 1000.0;  ///< stamp of the drive's time 0 [s]
};

/// One moment of a drive and what the mapper thought then.
struct MomentRecord {
  std::chrono::nanoseconds stamp{0};
  core::Pose2d odom;
  core::Pose2d truth;
  std::optional<core::Pose2d> online;  ///< where it thought to be
  bool carried = false;                ///< since the moment before
  double way = 0.0;                    ///< by odometry [m]
};

/// One scan's decision, and what was true then.
struct DecisionRecord {
  core::ScanDecision decision;
  std::size_t moment = 0;  ///< at which it was told
  double first_way = 0.0;  ///< ends of the scan's stretch, by odometry of this run [m]
  double last_way = 0.0;
  /// Whether the robot was elsewhere than it thought till then, beside the place that lay nearest;
  /// nothing where none was near, or it had no idea.
  std::optional<bool> astray;
};

/// What a mapper made of a drive.
struct MappingRun {
  std::vector<MomentRecord> moments;
  std::vector<DecisionRecord> decisions;  ///< as they came
  double cpu = 0.0;                       ///< of the mapper alone [s]

  double way() const { return moments.empty() ? 0.0 : moments.back().way; }
};

/// Where a robot was in truth, by stamp.
class Truth {
 public:
  void add(const MappingRun& run);
  void add(const MomentRecord& moment) { poses_[moment.stamp] = moment.truth; }
  /// At a stamp that is a moment's; nothing otherwise.
  std::optional<core::Pose2d> at(std::chrono::nanoseconds stamp) const;

 private:
  std::map<std::chrono::nanoseconds, core::Pose2d> poses_;
};

/// Feeds a mapper moment by moment, and writes down what it makes of them.
class MappingRecorder {
 public:
  /// Both must outlive it. `truth`: of what made the mapper's map before; this run's is added.
  MappingRecorder(core::Mapper& mapper, Truth& truth, bool compass, double start)
      : mapper_(mapper), truth_(truth), compass_(compass), start_(start) {}

  /// The moment knows its truth.
  void feed(const trials::DriveMoment& moment);
  std::chrono::nanoseconds stampOf(const trials::DriveMoment& moment) const;
  const MappingRun& run() const { return run_; }

 private:
  core::Mapper& mapper_;
  Truth& truth_;
  const bool compass_;
  const double start_;  ///< stamp of the drive's time 0 [s]
  MappingRun run_;
};

/// Feeds a part of a drive, all of which knows its truth. `truth`: of what made the mapper's map;
/// this drive's is added.
MappingRun drive(core::Mapper& mapper, const trials::Drive& drive, const DrivePart& part,
                 Truth& truth);

/// Odometry with the errors that results are reported at: 5 % of distances, 3 degrees a root metre.
struct OdometryNoise {
  double scale_sigma = 0.05;
  double yaw_noise = 3.0 * core::kPi / 180.0;  ///< [rad] by the root of the way [m]
};

}  // namespace place_memory::mapping

#endif  // PLACE_MEMORY_MAPPING_MAPPING_RUN_H
