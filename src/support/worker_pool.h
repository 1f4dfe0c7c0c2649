#ifndef PLACE_MEMORY_SUPPORT_WORKER_POOL_H
#define PLACE_MEMORY_SUPPORT_WORKER_POOL_H

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace place_memory::support {

/// As many as the processor runs at a time; at least 1.
std::size_t processorThreads();

/// Threads that wait for work: for some microseconds awake, since a search has one job soon after
/// the other and waking a thread takes as long as a small one; then asleep. Any number of callers
/// may share a pool.
class WorkerPool {
 public:
  /// `threads` work at a time, the caller among them; at least 1. Throws std::system_error where
  /// there can be no more threads.
  explicit WorkerPool(std::size_t threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// As many threads as the processor runs; made when first asked for.
  static WorkerPool& shared();

  std::size_t threads() const { return threads_.size() + 1; }

  /// Calls task(0) to task(tasks - 1), in any order and from several threads, and returns when all
  /// are done. `poll`, where given, is called by the caller's thread between its tasks. Once a task
  /// or `poll` throws, no further task is begun, and the call throws what was thrown first.
  void run(std::size_t tasks, const std::function<void(std::size_t)>& task,
           const std::function<void()>& poll = nullptr);

 private:
  struct Job;

  void work();
  void close();
  /// Does tasks of the job until none is left to begin; `poll` may be empty.
  static void takePart(Job& job, const std::function<void()>& poll);

  std::mutex mutex_;
  std::condition_variable job_came_;
  std::condition_variable helper_left_;
  std::list<Job*> jobs_;                  ///< those that helpers may join
  std::atomic<std::size_t> joinable_{0};  ///< their number, to be watched without the mutex
  std::atomic<bool> closing_{false};
  std::vector<std::thread> threads_;
};

}  // namespace place_memory::support

#endif  // PLACE_MEMORY_SUPPORT_WORKER_POOL_H
