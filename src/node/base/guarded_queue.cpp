#include "node/base/guarded_queue.h"

#include <ros/console.h>

#include <boost/make_shared.hpp>
#include <exception>
#include <utility>

#include "node/base/ros_time.h"

namespace place_memory::node {
namespace {

constexpr std::chrono::nanoseconds kPeriod = std::chrono::seconds(5);  // of saying it

using Report = std::function<void(const std::string& what)>;

class GuardedCallback : public ros::CallbackInterface {
 public:
  GuardedCallback(ros::CallbackInterfacePtr callback, Report report)
      : callback_(std::move(callback)), report_(std::move(report)) {}

  CallResult call() override {
    try {
      return callback_->call();
    } catch (const std::exception& error) {
      report_(error.what());
    } catch (...) {
      report_("something that is no std::exception");
    }
    return Success;
  }

  bool ready() override { return callback_->ready(); }

 private:
  ros::CallbackInterfacePtr callback_;
  Report report_;
};

}  // namespace

void GuardedQueue::addCallback(const ros::CallbackInterfacePtr& callback,
                               std::uint64_t removal_id) {
  ros::CallbackQueue::addCallback(boost::make_shared<GuardedCallback>(
                                      callback, [this](const std::string& what) { report(what); }),
                                  removal_id);
}

void GuardedQueue::report(const std::string& what) {
  // Not throttled by ROS time, which may be what is wrong.
  const std::int64_t now = steadyNow() / kPeriod;
  if (said_.exchange(now) != now) {
    ROS_ERROR("%s: an error in the node was caught: %s", work_.c_str(), what.c_str());
  }
  if (!on_error_) return;
  try {
    on_error_(what);
  } catch (const std::exception& error) {
    ROS_ERROR("%s: another one followed: %s", work_.c_str(), error.what());
  }
}

}  // namespace place_memory::node
