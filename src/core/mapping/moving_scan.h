#ifndef PLACE_MEMORY_CORE_MAPPING_MOVING_SCAN_H
#define PLACE_MEMORY_CORE_MAPPING_MOVING_SCAN_H

#include <chrono>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "place_memory/core/pose2d.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

struct MovingScanOptions {
  double spacing = 0.5;          ///< way from one scan to the next [m], > 0
  double length = 3.0;           ///< way that a scan reaches back [m]
  double length_ahead = 6.0;     ///< likewise where all sonars look ahead [m]
  double longest = 6.0;          ///< it grows so far to have readings enough [m]
  std::size_t readings = 90;     ///< that are enough
  std::size_t most = 180;        ///< readings; of more than these some are left out, evenly
  std::size_t most_ahead = 400;  ///< likewise where all sonars look ahead
};

/// Where the base is at one moment by odometry.
struct BaseMoment {
  std::chrono::nanoseconds stamp{0};
  Pose2d odom_from_base;  ///< raw
  Pose2d reckoned;        ///< the lasting errors of the wheels taken out
  double way = 0.0;       ///< driven till then [m]
  double turn = 0.0;      ///< measured till then, not wrapped [rad]
};

/// What the robot sensed along the last stretch of its way.
struct MovingScan {
  BaseMoment middle;       ///< of the stretch: what everything refers to
  double first_way = 0.0;  ///< the stretch's ends [m]
  double last_way = 0.0;
  /// In the base's frame at the middle of the stretch.
  std::shared_ptr<const std::vector<SonarReading>> readings;
  std::size_t first_newest = 0;  ///< of the readings, the first one from after the middle
  bool enough = true;            ///< false: fewer readings than asked for on the longest stretch
};

/// Lays readings that come while the robot drives out along odometry. Standing adds no way, and a
/// bounded number of readings.
class MovingScanBuilder {
 public:
  explicit MovingScanBuilder(const MovingScanOptions& options) : options_(options) {}

  /// In the order of stamps; the reading is in the base's frame.
  void add(const BaseMoment& moment, const SonarReading& reading);

  /// A scan, each time the robot came far enough since the last one and there are readings enough.
  std::optional<MovingScan> take();

  /// Forgets all readings: the robot was carried, or odometry jumped.
  void restart();

 private:
  /// Readings from one spot.
  struct Station {
    BaseMoment moment;
    std::vector<SonarReading> readings;
  };

  bool looksAhead() const;
  std::size_t middleOf(std::size_t first) const;

  MovingScanOptions options_;
  std::deque<Station> stations_;
  std::size_t kept_ = 0;       ///< readings of all stations
  std::size_t looked_at_ = 0;  ///< stations when it was last seen whether a scan is ready
  double last_scan_ = -1e9;    ///< way at which the last scan was taken
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_MOVING_SCAN_H
