#include "node/drive/drive_input.h"

#include <utility>

#include "node/base/ros_time.h"
#include "node/input/transform_filter.h"
#include "support/text.h"

namespace place_memory::node {
namespace {

using std::chrono::nanoseconds;

// A played bag's clock may come so much later than its messages, the faster the more.
constexpr nanoseconds kMaxAheadOfSimTime = std::chrono::seconds(10);
constexpr std::size_t kMostMoments = 500000;

nanoseconds maxAhead() { return ros::Time::isSimTime() ? kMaxAheadOfSimTime : kMaxAhead; }

}  // namespace

DriveInput::DriveInput(const config::Parameters& parameters)
    : parameters_(parameters), clock_(toNanoseconds(parameters.time_jump_tolerance)) {}

// The time is asked for under the mutex, so that no two callers make it seem to go back.
bool DriveInput::observeTime(nanoseconds now) {
  if (!on_ || now.count() == 0) return false;
  if (clock_.jumped(clock_.observe(now, steadyNow()))) {
    batch_.moments.clear();
    batch_.scans.clear();
    batch_.jumped = true;
  }
  return true;
}

void DriveInput::add(DriveMoment moment, nanoseconds now) {
  if (moment.stamp - now > maxAhead()) {
    batch_.losses.problem = "a message is stamped " + inSeconds(moment.stamp - now) +
                            " ahead of the clock: is the clock right where it comes from?";
    return;
  }
  if (batch_.moments.size() >= kMostMoments) {
    ++batch_.overrun;
    return;
  }
  batch_.moments.push_back(std::move(moment));
}

void DriveInput::take(const Taken& taken) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const nanoseconds now = rosNow();
  if (!observeTime(now)) return;
  for (DriveMoment& moment : momentsOf(taken, now, batch_.losses)) add(std::move(moment), now);
  left_.notify_one();
}

void DriveInput::take(const geometry_msgs::TransformStamped& transform, bool is_static) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // The stamp is looked at below.
  if (const auto problem = checkTransform(transform, true, {})) {
    batch_.losses.problem = "a transform was left out: " + *problem;
    return;
  }
  if (is_static) {
    const auto known = statics_.find(transform.child_frame_id);
    if (known == statics_.end() && statics_.size() >= kMostFrames) return;
    statics_[transform.child_frame_id] = transform;
    if (!on_) return;
    batch_.statics.push_back(transform);
    left_.notify_one();
    return;
  }
  const nanoseconds now = rosNow();
  if (!observeTime(now)) return;
  // The node's own is no part of the way from odometry to the sensors.
  if (support::withoutLeadingSlashes(transform.child_frame_id) == parameters_.odom_frame) return;
  DriveMoment moment = momentOf(transform, now);
  if (moment.stamp.count() == 0) return;
  // Whether it is too far ahead is seen to here.
  std::get<DrivenTransform>(moment.what).received = moment.stamp;
  add(std::move(moment), now);
  left_.notify_one();
}

void DriveInput::take(std::shared_ptr<const core::Scan> scan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!observeTime(rosNow())) return;
  batch_.scans.push_back(std::move(scan));
  left_.notify_one();
}

void DriveInput::turn(bool on) {
  const std::lock_guard<std::mutex> lock(mutex_);
  on_ = on;
  batch_ = Batch();
  clock_ = core::ClockWatch(toNanoseconds(parameters_.time_jump_tolerance));
  if (!on) return;
  for (const auto& [child, transform] : statics_) batch_.statics.push_back(transform);
}

DriveInput::Batch DriveInput::fetch(nanoseconds longest) {
  std::unique_lock<std::mutex> lock(mutex_);
  left_.wait_for(lock, longest, [this] {
    return woken_ || batch_.jumped || !batch_.moments.empty() || !batch_.statics.empty() ||
           !batch_.scans.empty();
  });
  woken_ = false;
  return std::exchange(batch_, Batch());
}

void DriveInput::wake() {
  const std::lock_guard<std::mutex> lock(mutex_);
  woken_ = true;
  left_.notify_one();
}

}  // namespace place_memory::node
