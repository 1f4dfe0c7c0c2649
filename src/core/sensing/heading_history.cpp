#include "core/sensing/heading_history.h"

#include <algorithm>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {

TimeOrder timeOrder(std::chrono::nanoseconds stamp, std::chrono::nanoseconds newest) {
  if (stamp >= newest) return TimeOrder::kForward;
  return newest - stamp <= kMaxDisorder ? TimeOrder::kLate : TimeOrder::kBackwards;
}

TimeOrder HeadingHistory::add(std::chrono::nanoseconds stamp, double yaw) {
  if (!samples_.empty()) {
    const TimeOrder order = timeOrder(stamp, samples_.back().stamp);
    if (order != TimeOrder::kForward) return order;
    if (stamp == samples_.back().stamp) samples_.pop_back();
  }
  samples_.push_back({stamp, yaw});
  if (samples_.size() > kMaxSamples) samples_.pop_front();
  return TimeOrder::kForward;
}

std::optional<double> HeadingHistory::at(std::chrono::nanoseconds stamp) const {
  const auto after =
      std::lower_bound(samples_.begin(), samples_.end(), stamp,
                       [](const Sample& s, std::chrono::nanoseconds t) { return s.stamp < t; });
  if (after != samples_.end() && after->stamp == stamp) return wrapAngle(after->yaw);
  if (after == samples_.begin()) return std::nullopt;

  const Sample& before = *std::prev(after);
  if (stamp - before.stamp > max_age_) return std::nullopt;
  if (after == samples_.end()) return wrapAngle(before.yaw);
  if (after->stamp - stamp > max_age_) return std::nullopt;

  const auto nanoseconds = [](std::chrono::nanoseconds t) {
    return static_cast<double>(t.count());
  };
  const double share = nanoseconds(stamp - before.stamp) / nanoseconds(after->stamp - before.stamp);
  return wrapAngle(before.yaw + share * wrapAngle(after->yaw - before.yaw));
}

std::optional<HeadingHistory::Sample> HeadingHistory::newest() const {
  if (samples_.empty()) return std::nullopt;
  return samples_.back();
}

}  // namespace place_memory::core
