#ifndef PLACE_MEMORY_NODE_GO_GOAL_WATCH_H
#define PLACE_MEMORY_NODE_GO_GOAL_WATCH_H

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "config/parameters.h"
#include "core/sensing/clock_watch.h"

namespace place_memory::node {

/// Watches what ends a goal for which the robot is driven, however well it drives.
class GoalWatch {
 public:
  enum class Kind { kTimeJumped, kTimeStands, kModeChanged };
  struct End {
    Kind kind;
    std::string why;  ///< in a sentence, and what to do
  };

  /// `tolerance`: ROS time may go back by so much.
  explicit GoalWatch(std::chrono::nanoseconds tolerance) : clock_(tolerance) {}

  /// A goal begins.
  void begin(std::chrono::nanoseconds now, config::Mode mode);
  std::optional<End> update(std::chrono::nanoseconds now, config::Mode mode);
  /// ROS time ran backwards. Thread-safe.
  void onTimeJump() { time_jumped_ = true; }
  /// When the goal began.
  config::Mode mode() const { return mode_; }

 private:
  core::ClockWatch clock_;
  config::Mode mode_ = config::Mode::kOff;
  std::atomic<bool> time_jumped_{false};
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_GO_GOAL_WATCH_H
