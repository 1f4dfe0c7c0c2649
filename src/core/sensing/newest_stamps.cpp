#include "core/sensing/newest_stamps.h"

#include <algorithm>

namespace place_memory::core {

TimeOrder NewestStamps::note(SensorId sensor, std::chrono::nanoseconds stamp) {
  std::chrono::nanoseconds& newest = newest_.emplace(sensor, stamp).first->second;
  const TimeOrder order = timeOrder(stamp, newest);
  newest = std::max(newest, stamp);
  return order;
}

}  // namespace place_memory::core
