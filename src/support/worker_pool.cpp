#include "support/worker_pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>

namespace place_memory::support {
namespace {

/// About what it takes to wake a thread.
constexpr std::chrono::microseconds kAwake{50};

/// Returns when `holds` does, or when it has not for a while.
template <typename Condition>
void watch(const Condition& holds) {
  const auto end = std::chrono::steady_clock::now() + kAwake;
  while (!holds() && std::chrono::steady_clock::now() < end) {
  }
}

}  // namespace

std::size_t processorThreads() {
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

struct WorkerPool::Job {
  Job(std::size_t all_tasks, const std::function<void(std::size_t)>& each_task)
      : tasks(all_tasks), task(each_task) {}

  const std::size_t tasks;
  const std::function<void(std::size_t)>& task;
  std::atomic<std::size_t> next{0};  ///< task to begin
  std::mutex mutex;
  std::exception_ptr error;
  std::atomic<std::size_t> helpers{0};  ///< that take part; changed under the pool's mutex
};

WorkerPool::WorkerPool(std::size_t threads) {
  try {
    for (std::size_t i = 1; i < threads; ++i) threads_.emplace_back([this] { work(); });
  } catch (...) {
    close();
    throw;
  }
}

WorkerPool::~WorkerPool() { close(); }

void WorkerPool::close() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
  }
  job_came_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

WorkerPool& WorkerPool::shared() {
  static WorkerPool pool(processorThreads());
  return pool;
}

void WorkerPool::run(std::size_t tasks, const std::function<void(std::size_t)>& task,
                     const std::function<void()>& poll) {
  Job job(tasks, task);
  const bool shares = tasks > 1 && !threads_.empty();
  if (shares) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      jobs_.push_back(&job);
      joinable_ = jobs_.size();
    }
    job_came_.notify_all();
  }
  takePart(job, poll);
  if (shares) {
    std::unique_lock<std::mutex> lock(mutex_);
    jobs_.remove(&job);
    joinable_ = jobs_.size();
    if (job.helpers > 0) {
      lock.unlock();
      watch([&job] { return job.helpers == 0; });
      lock.lock();
    }
    helper_left_.wait(lock, [&job] { return job.helpers == 0; });
  }
  if (job.error) std::rethrow_exception(job.error);
}

void WorkerPool::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    if (jobs_.empty() && !closing_) {
      lock.unlock();
      watch([this] { return joinable_ > 0 || closing_; });
      lock.lock();
    }
    job_came_.wait(lock, [this] { return closing_ || !jobs_.empty(); });
    if (closing_) return;
    Job& job = *jobs_.front();
    ++job.helpers;
    lock.unlock();
    takePart(job, nullptr);
    lock.lock();
    // All its tasks have been begun, so others must not join it any more.
    jobs_.remove(&job);
    joinable_ = jobs_.size();
    --job.helpers;
    helper_left_.notify_all();
  }
}

void WorkerPool::takePart(Job& job, const std::function<void()>& poll) {
  try {
    for (;;) {
      if (poll) poll();
      const std::size_t i = job.next.fetch_add(1);
      if (i >= job.tasks) return;
      job.task(i);
    }
  } catch (...) {
    job.next = job.tasks;
    const std::lock_guard<std::mutex> lock(job.mutex);
    if (!job.error) job.error = std::current_exception();
  }
}

}  // namespace place_memory::support
