#include "tools/stamp_order.h"

#include <algorithm>
#include <utility>

namespace place_memory::tools {
namespace {

// The stamps of one input do not go back further.
constexpr double kMaxDisorder = 1.0;

// So much later than expected a stamp may lie, beyond what BagClock::lateness counts.
constexpr double kMargin = 1.0;

}  // namespace

StampOrder::StampOrder(const rosbag::Bag& bag, const std::vector<std::string>& topics,
                       const BagClock& clock, const std::map<std::string, StampLayout>& layouts,
                       const ros::Time& start, const ros::Time& end)
    : clock_(clock), layouts_(layouts), start_(start), end_(end) {
  const ros::Time first = later(start, clock.offset - kMargin);
  const ros::Time last = later(end, clock.offset + clock.lateness);
  view_ = std::make_unique<rosbag::View>(bag, rosbag::TopicQuery(topics), first, last);
  at_ = view_->begin();
}

const TimedMessage* StampOrder::peek() {
  readAhead();
  return waiting_.empty() ? nullptr : &waiting_.top().timed;
}

TimedMessage StampOrder::take() {
  readAhead();
  TimedMessage timed = waiting_.top().timed;
  waiting_.pop();
  return timed;
}

// Until nothing that is still to come can be earlier than the earliest that waits.
void StampOrder::readAhead() {
  for (; at_ != view_->end(); ++at_) {
    const rosbag::MessageInstance& instance = *at_;
    const ros::Time earliest = later(clock_.received(instance.getTime()), -clock_.lateness);
    if (!waiting_.empty() && waiting_.top().timed.time < earliest) return;
    TimedMessage next = timed(instance);
    if (next.time >= start_ && next.time <= end_) waiting_.push({std::move(next), number_++});
  }
}

TimedMessage StampOrder::timed(const rosbag::MessageInstance& instance) {
  auto message = std::make_shared<const StoredMessage>(load(instance));
  const auto layout = layouts_.find(instance.getDataType());
  const auto origin =
      originOf(*message, layout == layouts_.end() ? StampLayout::kNone : layout->second);
  const bool trusted = origin && !clock_.isStray(*message, *origin) &&
                       clock_.credible(origin->stamp, message->recorded) &&
                       inOrder(*message, *origin);
  const ros::Time received = clock_.received(message->recorded);
  return {trusted ? origin->stamp : received, std::move(message), trusted};
}

bool StampOrder::inOrder(const StoredMessage& message, const Origin& origin) {
  ros::Time& newest = newest_[{message.topic, origin.frame}];
  if (later(origin.stamp, kMaxDisorder) < newest) return false;
  newest = std::max(newest, origin.stamp);
  return true;
}

}  // namespace place_memory::tools
