#include "node/map/rated_task.h"

#include <ros/console.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <utility>

namespace place_memory::node {
namespace {

constexpr int kPauses = 19;  // as long as the task was at work

/// That this thread was at work. The clock on the wall counts what other programs do meanwhile: on
/// a busy machine a task would come a minute late.
std::chrono::nanoseconds workTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

}  // namespace

RatedTask::RatedTask(std::string what, std::function<void()> task,
                     std::chrono::nanoseconds least_pause)
    : what_(std::move(what)), task_(std::move(task)), least_pause_(least_pause) {
  thread_ = std::thread([this] { run(); });
}

RatedTask::~RatedTask() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void RatedTask::request() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requested_ = true;
  }
  changed_.notify_all();
}

void RatedTask::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return requested_ || stopped_; });
    if (stopped_) return;
    requested_ = false;
    lock.unlock();
    const std::chrono::nanoseconds begin = workTime();
    doTask();
    const auto pause = std::max(least_pause_, kPauses * (workTime() - begin));
    lock.lock();
    if (changed_.wait_for(lock, pause, [this] { return stopped_; })) return;
  }
}

void RatedTask::doTask() const {
  try {
    task_();
  } catch (const std::exception& error) {
    ROS_ERROR("%s: %s", what_.c_str(), error.what());
  }
}

}  // namespace place_memory::node
