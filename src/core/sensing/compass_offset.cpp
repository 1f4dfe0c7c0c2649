#include "core/sensing/compass_offset.h"

#include <cmath>

namespace place_memory::core {

void CompassOffset::add(std::chrono::nanoseconds stamp, std::chrono::nanoseconds deadline,
                        double heading) {
  waiting_.push_back({stamp, deadline, heading});
}

void CompassOffset::process(std::chrono::nanoseconds now, const YawAt& yaw_at) {
  std::deque<Waiting> still_waiting;
  for (const Waiting& heading : waiting_) {
    if (const auto yaw = yaw_at(heading.stamp)) {
      sum_sin_ += std::sin(heading.heading - *yaw);
      sum_cos_ += std::cos(heading.heading - *yaw);
    } else if (now < heading.deadline) {
      still_waiting.push_back(heading);
    }
  }
  waiting_.swap(still_waiting);
}

std::optional<double> CompassOffset::mean() const {
  if (sum_sin_ == 0.0 && sum_cos_ == 0.0) return std::nullopt;
  return std::atan2(sum_sin_, sum_cos_);
}

}  // namespace place_memory::core
