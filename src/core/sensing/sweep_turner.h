#ifndef PLACE_MEMORY_CORE_SENSING_SWEEP_TURNER_H
#define PLACE_MEMORY_CORE_SENSING_SWEEP_TURNER_H

#include <optional>

namespace place_memory::core {

/// Turns a robot through a sweep that lies evenly about the heading at which it began, and back
/// there (paper 3.1.4). A sweep of a full turn begins where the robot stands.
///
/// A feedback controller: it is told the robot's yaw again and again and answers with the rate to
/// turn at. It stays at each heading of the sweep until that heading is over.
class SweepTurner {
 public:
  /// `headings` >= 1; `step` between them [rad], > 0; `max_rate` [rad/s], > 0.
  SweepTurner(int headings, double step, double max_rate);

  /// `yaw` of the robot now [rad], by any steady reference; between two calls it may turn by less
  /// than pi. `completed` is how many headings of the sweep are over. Returns the rate to turn at
  /// [rad/s], counter-clockwise.
  double update(double yaw, int completed);

  /// The robot has come to the first heading of the sweep.
  bool started() const { return phase_ != Phase::kToFirst; }
  /// Every heading is over: the robot turns back.
  bool swept() const { return phase_ == Phase::kBack || phase_ == Phase::kDone; }
  bool done() const { return phase_ == Phase::kDone; }

 private:
  enum class Phase { kToFirst, kSweep, kBack, kDone };

  double target(int completed) const;

  int headings_;
  double step_;
  double max_rate_;
  double tolerance_;  // at a heading of the sweep [rad]
  double first_;      // heading of the sweep, from where the robot began [rad]
  Phase phase_ = Phase::kToFirst;
  std::optional<double> last_yaw_;
  double turned_ = 0.0;  // since the robot began [rad]
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_SWEEP_TURNER_H
