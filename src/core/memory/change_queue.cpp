#include "core/memory/change_queue.h"

#include <stdexcept>

namespace place_memory::core {

ChangeQueue::~ChangeQueue() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void ChangeQueue::post(std::function<void()> work) {
  if (std::this_thread::get_id() == thread_.get_id()) {
    throw std::logic_error("a listener of the map must not ask for a change of it, nor for a grid");
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    works_.push_back(std::move(work));
  }
  changed_.notify_one();
}

void ChangeQueue::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ends_ || !works_.empty(); });
    if (works_.empty()) return;
    const std::function<void()> next = std::move(works_.front());
    works_.pop_front();
    lock.unlock();
    next();
    lock.lock();
  }
}

}  // namespace place_memory::core
