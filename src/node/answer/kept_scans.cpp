#include "node/answer/kept_scans.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace place_memory::node {
namespace {

constexpr char kWait[] = "one is under way: wait for the result of the action ~scan";

std::string wholeSeconds(double seconds) { return std::to_string(std::lround(seconds)) + " s"; }

}  // namespace

KeptScans::KeptScans(double max_age) : max_age_(max_age) {}

void KeptScans::add(std::shared_ptr<const core::Scan> scan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scans_.push_front(std::move(scan));
  if (scans_.size() > kMost) scans_.pop_back();
}

void KeptScans::drop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  scans_.clear();
}

void KeptScans::setUnderWay(bool under_way) {
  const std::lock_guard<std::mutex> lock(mutex_);
  under_way_ = under_way;
}

std::shared_ptr<const core::Scan> KeptScans::find(std::uint64_t id) const {
  if (scans_.empty()) return nullptr;
  if (id == 0) return scans_.front();
  const auto found =
      std::find_if(scans_.begin(), scans_.end(), [id](const auto& scan) { return scan->id == id; });
  return found == scans_.end() ? nullptr : *found;
}

ScanChoice KeptScans::choose(std::uint64_t id, std::chrono::nanoseconds now) const {
  using Problem = ScanChoice::Problem;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (scans_.empty()) {
    return {Problem::kNoScan,
            under_way_ ? std::string("there is no scan yet, ") + kWait
                       : "there is no scan: call the action ~scan first",
            nullptr};
  }
  std::shared_ptr<const core::Scan> scan = find(id);
  if (!scan) {
    return {Problem::kUnknown,
            "there is no scan " + std::to_string(id) + " among the " +
                std::to_string(scans_.size()) + " newest, which are kept: scan again",
            nullptr};
  }
  const double age = std::chrono::duration<double>(now - scan->end).count();
  if (age > max_age_) {
    return {Problem::kTooOld,
            "the scan is " + wholeSeconds(age) + " old, and scan/max_age is " +
                wholeSeconds(max_age_) + ": scan again",
            nullptr};
  }
  std::string note;
  if (under_way_ && id == 0) note = std::string("by the scan before, since ") + kWait;
  return {Problem::kNone, note, std::move(scan)};
}

}  // namespace place_memory::node
