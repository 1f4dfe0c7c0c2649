#include "node/scan/compass_offset.h"

#include <cmath>

namespace place_memory::node {

void CompassOffset::add(const ros::Time& stamp, const ros::Time& deadline, double heading) {
  waiting_.push_back({stamp, deadline, heading});
}

void CompassOffset::process(const ros::Time& now, const YawAt& yaw_at) {
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

}  // namespace place_memory::node
