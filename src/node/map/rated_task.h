#ifndef PLACE_MEMORY_NODE_MAP_RATED_TASK_H
#define PLACE_MEMORY_NODE_MAP_RATED_TASK_H

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace place_memory::node {

/// Does on a thread of its own what may be asked for oftener than it should be done.
///
/// After each request it is done once from the beginning, at once or when the pause after the last
/// time is over; requests that come meanwhile are one. What has much to do pauses for longer, so
/// that it takes one part in twenty of a core at most.
class RatedTask {
 public:
  /// `what`: for the log, should the task throw.
  RatedTask(std::string what, std::function<void()> task, std::chrono::nanoseconds least_pause);
  /// Waits for a task that runs; none begins any more.
  ~RatedTask();
  RatedTask(const RatedTask&) = delete;
  RatedTask& operator=(const RatedTask&) = delete;

  /// Returns at once. Thread-safe.
  void request();

 private:
  void run();
  void doTask() const;

  const std::string what_;
  const std::function<void()> task_;
  const std::chrono::nanoseconds least_pause_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool requested_ = false;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_MAP_RATED_TASK_H
