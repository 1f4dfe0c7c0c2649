#ifndef PLACE_MEMORY_CORE_SENSING_HEADING_HISTORY_H
#define PLACE_MEMORY_CORE_SENSING_HEADING_HISTORY_H

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>

namespace place_memory::core {

/// What became of a sample, or of a message, by its stamp.
enum class TimeOrder {
  kForward,    ///< not before the newest
  kLate,       ///< before the newest, by kMaxDisorder at most: messages overtook each other
  kBackwards,  ///< further back: the stamp is stale, as after a sensor's board restarted
};

/// Messages of one robot may overtake each other by so much.
constexpr std::chrono::nanoseconds kMaxDisorder = std::chrono::seconds(1);

TimeOrder timeOrder(std::chrono::nanoseconds stamp, std::chrono::nanoseconds newest);

/// Compass headings by their stamps, the newest ones only.
class HeadingHistory {
 public:
  static constexpr std::size_t kMaxSamples = 4096;

  struct Sample {
    std::chrono::nanoseconds stamp{0};
    double yaw = 0.0;  ///< [rad]
  };

  /// A sample is believed for `max_age` before and after its stamp, > 0.
  explicit HeadingHistory(std::chrono::nanoseconds max_age) : max_age_(max_age) {}

  /// Keeps the sample if it is in order and leaves it out otherwise.
  TimeOrder add(std::chrono::nanoseconds stamp, double yaw);

  /// Heading at a stamp in [-pi, pi) [rad]: between two samples on the shorter way from one to the
  /// other, after the newest one its own. Nothing where the samples next to it are older or younger
  /// than the age to which they are believed.
  std::optional<double> at(std::chrono::nanoseconds stamp) const;

  std::optional<Sample> newest() const;
  std::size_t size() const { return samples_.size(); }
  void clear() { samples_.clear(); }

 private:
  std::chrono::nanoseconds max_age_;
  std::deque<Sample> samples_;  // stamps ascend strictly
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_HEADING_HISTORY_H
