#include "tools/bag_merge.h"

#include <algorithm>

namespace place_memory::tools {

StampOrder* BagMerge::earliest() {
  StampOrder* earliest = nullptr;
  for (StampOrder& order : orders_) {
    const TimedMessage* const one = order.peek();
    if (one == nullptr) continue;
    if (earliest == nullptr || one->time < earliest->peek()->time) earliest = &order;
  }
  return earliest;
}

bool BagMerge::isCopy(const StampOrder& from, const TimedMessage& timed) {
  if (!now_.empty() && now_.front().timed.time != timed.time) now_.clear();
  const auto bag = static_cast<std::size_t>(&from - orders_.data());
  const bool is_copy = std::any_of(now_.begin(), now_.end(), [&](const Visited& visited) {
    const StoredMessage& message = *visited.timed.message;
    return visited.bag != bag && message.topic == timed.message->topic &&
           message.bytes == timed.message->bytes;
  });
  if (!is_copy) now_.push_back({bag, timed});
  return is_copy;
}

std::optional<TimedMessage> BagMerge::next() {
  while (StampOrder* const order = earliest()) {
    TimedMessage timed = order->take();
    if (orders_.size() == 1 || !isCopy(*order, timed)) return timed;
  }
  return std::nullopt;
}

}  // namespace place_memory::tools
