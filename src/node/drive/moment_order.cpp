#include "node/drive/moment_order.h"

#include <algorithm>
#include <iterator>

namespace place_memory::node {

using std::chrono::nanoseconds;

bool MomentOrder::add(DriveMoment moment, nanoseconds steady) {
  if (begun_.count() < 0) begun_ = steady;
  const nanoseconds stamp = moment.stamp;
  if (stamp < let_go_) return false;
  Newest& newest = inputs_[{moment.what.index(), moment.frame()}];
  newest.stamp = std::max(newest.stamp, stamp);
  newest.heard = steady;
  arrivals_.push_back({steady, stamp});
  waiting_.insert(std::move(moment));
  return true;
}

std::vector<DriveMoment> MomentOrder::take(nanoseconds steady) {
  std::vector<DriveMoment> ready;
  // At first not every input has been heard.
  if (waiting_.empty() || steady - begun_ < kPatience) return ready;
  nanoseconds passed = nanoseconds::max();
  for (auto input = inputs_.begin(); input != inputs_.end();) {
    if (steady - input->second.heard > kSilence) {
      input = inputs_.erase(input);
      continue;
    }
    passed = std::min(passed, input->second.stamp);
    ++input;
  }
  while (!arrivals_.empty() && steady - arrivals_.front().steady >= kPatience) {
    overdue_ = std::max(overdue_, arrivals_.front().stamp);
    arrivals_.pop_front();
  }
  // More of the very stamp that an input came to may follow.
  while (!waiting_.empty() &&
         (waiting_.begin()->stamp < passed || waiting_.begin()->stamp <= overdue_)) {
    let_go_ = std::max(let_go_, waiting_.begin()->stamp);
    ready.push_back(std::move(waiting_.extract(waiting_.begin()).value()));
  }
  return ready;
}

void MomentOrder::clear() { *this = MomentOrder(); }

}  // namespace place_memory::node
