#ifndef PLACE_MEMORY_CORE_SENSING_COMPASS_WATCH_H
#define PLACE_MEMORY_CORE_SENSING_COMPASS_WATCH_H

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>

namespace place_memory::core {

/// Whether compass and odometry turn alike.
class CompassWatch {
 public:
  enum class Fault {
    kCompassStands,    ///< while odometry turns
    kCompassOtherWay,  ///< than odometry
    kOdometryStands,   ///< while the compass turns
  };
  struct Finding {
    Fault fault;
    double compass = 0.0;   ///< turned, as far as odometry's turn explains it [rad]
    double odometry = 0.0;  ///< turned back and forth by so much [rad]
  };

  /// Both as they were at the stamp [rad]. One less than 50 ms after the one before is left out; a
  /// stamp that goes back is of another time, and what was before is forgotten.
  void add(std::chrono::nanoseconds stamp, double heading, double yaw);
  void clear() { samples_.clear(); }

  /// From the stamp on. Nothing is found before odometry has turned by 0.2 rad, or the compass by
  /// 0.35 rad within ten seconds. A compass that errs with the heading, as all do, is none of
  /// those.
  std::optional<Finding> find(std::chrono::nanoseconds from) const;
  /// Whether, from the stamp on, odometry has turned by 0.2 rad, and the compass with it.
  bool agree(std::chrono::nanoseconds from) const;
  std::optional<std::chrono::nanoseconds> newest() const;

 private:
  static constexpr std::size_t kMost = 2400;

  struct Sample {
    std::chrono::nanoseconds stamp;
    double heading;  // both go on beyond a full turn
    double yaw;
  };

  std::deque<Sample> samples_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_COMPASS_WATCH_H
