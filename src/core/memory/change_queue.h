#ifndef PLACE_MEMORY_CORE_MEMORY_CHANGE_QUEUE_H
#define PLACE_MEMORY_CORE_MEMORY_CHANGE_QUEUE_H

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

namespace place_memory::core {

/// Does works one after the other on one thread, in the order in which they were asked for.
class ChangeQueue {
 public:
  ChangeQueue() : thread_([this] { work(); }) {}
  /// Does what was asked for first.
  ~ChangeQueue();
  ChangeQueue(const ChangeQueue&) = delete;
  ChangeQueue& operator=(const ChangeQueue&) = delete;

  /// Has the work done and waits for it; returns what it returns, throws what it throws. Throws
  /// std::logic_error where a work of this queue calls it: it would wait for itself.
  template <class Work>
  auto run(Work work) -> decltype(work()) {
    std::packaged_task<decltype(work())()> task(std::move(work));
    auto done = task.get_future();
    post([&task] { task(); });
    return done.get();
  }

 private:
  void post(std::function<void()> work);
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> works_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_CHANGE_QUEUE_H
