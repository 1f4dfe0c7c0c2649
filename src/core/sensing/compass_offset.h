#ifndef PLACE_MEMORY_CORE_SENSING_COMPASS_OFFSET_H
#define PLACE_MEMORY_CORE_SENSING_COMPASS_OFFSET_H

#include <chrono>
#include <deque>
#include <functional>
#include <optional>

namespace place_memory::core {

/// By how much the compass reads more than odometry's yaw, over one scan. Headings whose odometry
/// is not there yet wait for it.
class CompassOffset {
 public:
  /// Yaw of the base in odometry's frame at a stamp, where it is known [rad].
  using YawAt = std::function<std::optional<double>(std::chrono::nanoseconds stamp)>;

  /// Waits until `deadline` at the latest. `heading` in [rad].
  void add(std::chrono::nanoseconds stamp, std::chrono::nanoseconds deadline, double heading);
  void process(std::chrono::nanoseconds now, const YawAt& yaw_at);
  void clearWaiting() { waiting_.clear(); }

  /// [rad]; nothing before a heading could be used.
  std::optional<double> mean() const;

 private:
  struct Waiting {
    std::chrono::nanoseconds stamp;
    std::chrono::nanoseconds deadline;
    double heading;
  };

  std::deque<Waiting> waiting_;
  double sum_sin_ = 0.0;
  double sum_cos_ = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_COMPASS_OFFSET_H
