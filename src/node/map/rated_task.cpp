#include "node/map/rated_task.h"

#include <ros/console.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace place_memory::node {
namespace {

constexpr int kPauses = 19;  // as long as the task took

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
    const auto begin = std::chrono::steady_clock::now();
    doTask();
    const auto end = std::chrono::steady_clock::now();
    lock.lock();
    const auto pause = std::max<std::chrono::nanoseconds>(least_pause_, kPauses * (end - begin));
    if (changed_.wait_until(lock, end + pause, [this] { return stopped_; })) return;
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
