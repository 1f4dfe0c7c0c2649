#ifndef PLACE_MEMORY_CORE_SENSING_CLOCK_WATCH_H
#define PLACE_MEMORY_CORE_SENSING_CLOCK_WATCH_H

#include <algorithm>
#include <chrono>

namespace place_memory::core {

/// Whether a clock that somebody else sets goes backwards or stands still.
class ClockWatch {
 public:
  /// It may go back by `tolerance` without having been set back: two sources of simulated time and
  /// the correction of a machine's clock do so. >= 0.
  explicit ClockWatch(std::chrono::nanoseconds tolerance) : tolerance_(tolerance) {}

  /// What the clock says at a moment of one that nobody sets. Returns by how much it is behind the
  /// latest it ever said; 0: not at all. After more than the tolerance it is taken as it is.
  std::chrono::nanoseconds observe(std::chrono::nanoseconds now, std::chrono::nanoseconds steady) {
    if (now != now_) changed_ = steady;
    now_ = now;
    const std::chrono::nanoseconds behind = std::max(latest_ - now, std::chrono::nanoseconds(0));
    latest_ = jumped(behind) ? now : std::max(latest_, now);
    return behind;
  }

  bool jumped(std::chrono::nanoseconds behind) const { return behind > tolerance_; }

  /// Counts from here how long the clock stands.
  void restart(std::chrono::nanoseconds steady) { changed_ = steady; }
  std::chrono::nanoseconds standing(std::chrono::nanoseconds steady) const {
    return steady - changed_;
  }

 private:
  std::chrono::nanoseconds tolerance_;
  std::chrono::nanoseconds now_{0};
  std::chrono::nanoseconds latest_{0};
  std::chrono::nanoseconds changed_{0};  // by the steady clock
};

/// Time that passed while a clock that somebody else sets went forward: a step of it, in either
/// direction, counts for three seconds at the most and not for less than none.
class ForwardTime {
 public:
  static constexpr std::chrono::seconds kLongestStep{3};

  void observe(std::chrono::nanoseconds now) {
    const std::chrono::nanoseconds step = started_ ? now - last_ : std::chrono::nanoseconds(0);
    passed_ +=
        std::clamp<std::chrono::nanoseconds>(step, std::chrono::nanoseconds(0), kLongestStep);
    last_ = now;
    started_ = true;
  }

  std::chrono::nanoseconds passed() const { return passed_; }

 private:
  bool started_ = false;
  std::chrono::nanoseconds last_{0};
  std::chrono::nanoseconds passed_{0};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_CLOCK_WATCH_H
