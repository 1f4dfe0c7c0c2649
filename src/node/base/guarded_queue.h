#ifndef PLACE_MEMORY_NODE_BASE_GUARDED_QUEUE_H
#define PLACE_MEMORY_NODE_BASE_GUARDED_QUEUE_H

#include <ros/callback_queue.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace place_memory::node {

/// A callback queue on which nothing that a callback throws gets out: on a spinner's thread that
/// would end the process, and a robot that turns would turn on. It is said in the log instead, and
/// the next callback has its turn. Messages, timers and services come by a queue alike.
class GuardedQueue : public ros::CallbackQueue {
 public:
  /// Told what was thrown, on the thread of the callback.
  using OnError = std::function<void(const std::string& what)>;

  /// `work`: what the callbacks do, for the log.
  explicit GuardedQueue(std::string work, OnError on_error = nullptr)
      : work_(std::move(work)), on_error_(std::move(on_error)) {}

  void addCallback(const ros::CallbackInterfacePtr& callback,
                   std::uint64_t removal_id = 0) override;

 private:
  void report(const std::string& what);

  std::string work_;
  OnError on_error_;
  std::atomic<std::int64_t> said_{-1};  // when, in whole periods of a clock that nobody sets
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_GUARDED_QUEUE_H
