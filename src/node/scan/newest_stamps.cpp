#include "node/scan/newest_stamps.h"

namespace place_memory::node {

core::TimeOrder NewestStamps::note(const std::string& frame, std::chrono::nanoseconds stamp) {
  const auto known = newest_.find(frame);
  if (known == newest_.end()) {
    if (newest_.size() < kMaxFrames) newest_[frame] = stamp;
    return core::TimeOrder::kForward;
  }
  const core::TimeOrder order = core::timeOrder(stamp, known->second);
  if (order != core::TimeOrder::kLate) known->second = stamp;
  return order;
}

}  // namespace place_memory::node
