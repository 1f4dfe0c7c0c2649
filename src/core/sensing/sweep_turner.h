#ifndef PLACE_MEMORY_CORE_SENSING_SWEEP_TURNER_H
#define PLACE_MEMORY_CORE_SENSING_SWEEP_TURNER_H

#include <chrono>
#include <optional>

#include "core/sensing/base_watch.h"

namespace place_memory::core {

/// Turns a robot through a sweep that lies evenly about the heading at which it began, and back
/// there (paper 3.1.4). A sweep of a full turn begins where the robot stands.
///
/// A feedback controller: it is told the robot's yaw again and again and answers with the rate to
/// turn at. It stays at each heading of the sweep until that heading is over. A heading that was
/// passed counts as reached, so that a base which obeys late, in coarse steps, or not at low rates
/// does not swing about it.
class SweepTurner {
 public:
  /// `headings` >= 1; `step` between them [rad], > 0; `max_rate` [rad/s], > 0; `least_rate` is the
  /// base's dead band [rad/s], at most `max_rate`; 0: it is found out.
  SweepTurner(int headings, double step, double max_rate, double least_rate = 0.0);

  /// `yaw` of the robot at `now` [rad], by any steady reference; between two calls it may turn by
  /// less than pi. `completed` is how many headings of the sweep are over, `here_over` whether that
  /// is so of the one at which the robot is. Returns the rate to turn at [rad/s],
  /// counter-clockwise.
  double update(std::chrono::nanoseconds now, double yaw, int completed, bool here_over);

  /// The robot has come to the first heading of the sweep.
  bool started() const { return phase_ > Phase::kToFirst; }
  /// Every heading is over: the robot turns back.
  bool swept() const { return phase_ >= Phase::kBack; }
  bool done() const { return phase_ == Phase::kDone; }

  /// How the base obeys.
  const BaseWatch& base() const { return base_; }

 private:
  enum class Phase { kSettle, kToFirst, kSweep, kBack, kDone };

  bool stands(double now);
  void goOn(double now, int completed, bool here_over);
  void aimAt(double target, int completed);
  void noteReached(double now);
  double rate() const;

  int headings_;
  double step_;
  double max_rate_;
  double tolerance_;  // at a heading of the sweep [rad]
  double first_;      // heading of the sweep, from where the robot began [rad]
  BaseWatch base_;
  Phase phase_ = Phase::kSettle;
  std::optional<std::chrono::nanoseconds> start_;
  double last_yaw_ = 0.0;
  double turned_ = 0.0;  // since the robot began [rad]
  double sent_ = 0.0;    // the rate of the update before

  double settled_at_ = 0.0;  // heading about which it stands [rad]
  double settled_since_ = 0.0;

  double target_ = 0.0;
  double direction_ = 0.0;  // in which the target lay
  int completed_before_ = 0;
  bool reached_ = false;
  double reached_since_ = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_SWEEP_TURNER_H
