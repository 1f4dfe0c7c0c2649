#ifndef PLACE_MEMORY_CORE_SENSING_RECENT_COUNT_H
#define PLACE_MEMORY_CORE_SENSING_RECENT_COUNT_H

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace place_memory::core {

/// How often something happened within the last ten seconds, to one second.
class RecentCount {
 public:
  static constexpr std::size_t kSeconds = 10;

  /// `now` >= 0, and never before an earlier one.
  void add(std::chrono::nanoseconds now) {
    const std::size_t second = secondOf(now);
    for (std::size_t s = newest_ + 1; s <= second && s <= newest_ + kSeconds; ++s) {
      counts_[s % kSeconds] = 0;
    }
    newest_ = second;
    ++counts_[second % kSeconds];
  }

  std::uint32_t at(std::chrono::nanoseconds now) const {
    const std::size_t second = secondOf(now);
    std::uint32_t sum = 0;
    for (std::size_t age = second - newest_; age < kSeconds; ++age) {
      if (age <= second) sum += counts_[(second - age) % kSeconds];
    }
    return sum;
  }

 private:
  static std::size_t secondOf(std::chrono::nanoseconds now) {
    return static_cast<std::size_t>(std::chrono::duration_cast<std::chrono::seconds>(now).count());
  }

  std::array<std::uint32_t, kSeconds> counts_{};  // of a second s: at s % kSeconds
  std::size_t newest_ = 0;                        // second in which something happened last
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_RECENT_COUNT_H
