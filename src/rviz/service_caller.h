#ifndef PLACE_MEMORY_RVIZ_SERVICE_CALLER_H
#define PLACE_MEMORY_RVIZ_SERVICE_CALLER_H

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "rviz/background_thread.h"

namespace place_memory::panel {

enum class CallEnd {
  kAnswered,
  kUnreachable,  ///< nothing answers there, or it broke off
  kTimedOut,
};

/// Calls services one after the other on a thread of its own, and lets go of a call that takes too
/// long: ROS itself would wait for ever on a server that hangs.
class ServiceCaller {
 public:
  using Clock = std::chrono::steady_clock;
  template <class Service>
  using OnEnd = std::function<void(CallEnd end, const typename Service::Response& response)>;

  ServiceCaller() = default;
  ServiceCaller(const ServiceCaller&) = delete;
  ServiceCaller& operator=(const ServiceCaller&) = delete;

  /// Lets go of every call; no on_end is called any more once it returns.
  ~ServiceCaller();

  /// Returns at once. `on_end` is called once: on the thread of the calls, or on the one that calls
  /// expire(). The time-out counts from now, so also while other calls are under way.
  template <class Service>
  void call(const std::string& service, const typename Service::Request& request,
            std::chrono::milliseconds time_out, const OnEnd<Service>& on_end);

  /// Ends the calls whose time is over. To be called again and again, from one thread.
  void expire(Clock::time_point now = Clock::now());

 private:
  /// A call under way. It is over for one of: answer, time-out, end of the caller.
  class Pending {
   public:
    Pending(Clock::time_point deadline, std::function<void()> on_time_out)
        : deadline_(deadline), on_time_out_(std::move(on_time_out)) {}

    bool isDue(Clock::time_point now) const { return now >= deadline_; }
    bool isOver() const;
    /// From here on the call can be let go of. False where it is over already.
    bool connected(const ros::ServiceClient& client);
    /// `tell` is called if the call is not over yet; then it is.
    void finish(const std::function<void()>& tell);
    void timeOut() { breakOff(on_time_out_); }
    void drop() { breakOff(nullptr); }

   private:
    void breakOff(const std::function<void()>& tell);

    const Clock::time_point deadline_;
    const std::function<void()> on_time_out_;
    mutable std::mutex mutex_;
    bool over_ = false;
    ros::ServiceClient client_;
  };

  std::vector<std::shared_ptr<Pending>> pending_;
  std::mutex mutex_;
  BackgroundThread thread_;
};

template <class Service>
void ServiceCaller::call(const std::string& service, const typename Service::Request& request,
                         std::chrono::milliseconds time_out, const OnEnd<Service>& on_end) {
  const auto pending = std::make_shared<Pending>(Clock::now() + time_out, [on_end] {
    on_end(CallEnd::kTimedOut, typename Service::Response());
  });
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    pending_.push_back(pending);
  }
  thread_.post([pending, service, request, on_end] {
    if (pending->isOver()) return;
    typename Service::Response response;
    // Persistent: only then can another thread end a call that hangs.
    ros::NodeHandle node;
    ros::ServiceClient client = node.serviceClient<Service>(service, true);
    const bool answered =
        pending->connected(client) && client.isValid() && client.call(request, response);
    pending->finish(
        [&] { on_end(answered ? CallEnd::kAnswered : CallEnd::kUnreachable, response); });
  });
}

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_SERVICE_CALLER_H
