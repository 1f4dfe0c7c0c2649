#ifndef PLACE_MEMORY_CORE_DRIVE_ECHO_RING_H
#define PLACE_MEMORY_CORE_DRIVE_ECHO_RING_H

#include <chrono>
#include <map>
#include <utility>

#include "core/sensing/measurement.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// The newest word of each sonar, as points about the robot: x ahead, y to the left.
class EchoRing {
 public:
  /// What was heard longer ago than `memory` says nothing any more.
  explicit EchoRing(std::chrono::nanoseconds memory) : memory_(memory) {}

  /// `range` [m]; infinite: no echo. A sensor that has many cones, as a laser, is heard in each of
  /// them.
  void hear(SensorId sensor, std::chrono::nanoseconds stamp, const Pose2d& base_from_sensor,
            double range);

  /// Whether no sonar that looks ahead, by less than a right angle to either side, was heard
  /// lately.
  bool isBlind(std::chrono::nanoseconds now) const;
  /// From the robot's middle to the nearest echo within `half_width` of the way ahead [m]; infinite
  /// where there is none.
  double ahead(std::chrono::nanoseconds now, double half_width) const {
    return along(now, 0.0, half_width);
  }
  double behind(std::chrono::nanoseconds now, double half_width) const {
    return along(now, kPi, half_width);
  }
  /// Likewise of a way that begins in another direction [rad].
  double along(std::chrono::nanoseconds now, double bearing, double half_width) const;
  /// Whether a sonar that looks there, but for `within` [rad], was heard lately.
  bool looks(std::chrono::nanoseconds now, double bearing, double within) const;
  /// How far to the left (`side` 1) or right (-1) of the way ahead the nearest echo lies that is no
  /// further ahead than `reach` [m].
  double beside(std::chrono::nanoseconds now, double side, double reach) const;

 private:
  struct Heard {
    std::chrono::nanoseconds stamp{0};
    Pose2d base_from_sensor;
    double range = 0.0;
  };

  template <class Take>
  void forEachEcho(std::chrono::nanoseconds now, const Take& take) const;

  std::chrono::nanoseconds memory_;
  std::map<std::pair<SensorId, long>, Heard> heard_;  // by sensor and bearing [degrees]
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_DRIVE_ECHO_RING_H
