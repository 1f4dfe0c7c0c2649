#include "node/guarded_queue.h"

#include <ros/console.h>

#include <boost/make_shared.hpp>
#include <exception>
#include <utility>

namespace place_memory::node {
namespace {

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

void GuardedQueue::report(const std::string& what) const {
  constexpr double kPeriod = 5.0;  // [s]
  ROS_ERROR_THROTTLE(kPeriod, "%s: an error in the node was caught: %s", work_.c_str(),
                     what.c_str());
  if (!on_error_) return;
  try {
    on_error_(what);
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(kPeriod, "%s: another one followed: %s", work_.c_str(), error.what());
  }
}

}  // namespace place_memory::node
