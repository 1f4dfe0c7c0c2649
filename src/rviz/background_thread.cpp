#include "rviz/background_thread.h"

#include <chrono>
#include <utility>

namespace place_memory::panel {
namespace {

constexpr std::chrono::seconds kPatience(2);

}  // namespace

BackgroundThread::BackgroundThread() : thread_([state = state_] { run(*state); }) {}

BackgroundThread::~BackgroundThread() {
  std::unique_lock<std::mutex> lock(state_->mutex);
  state_->stop = true;
  state_->changed.notify_all();
  const bool ended = state_->changed.wait_for(lock, kPatience, [this] { return state_->ended; });
  lock.unlock();
  if (ended) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

void BackgroundThread::post(Work work) {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  state_->work.push_back(std::move(work));
  state_->changed.notify_all();
}

void BackgroundThread::run(State& state) {
  std::unique_lock<std::mutex> lock(state.mutex);
  for (;;) {
    state.changed.wait(lock, [&state] { return state.stop || !state.work.empty(); });
    if (state.work.empty()) break;
    Work work = std::move(state.work.front());
    state.work.pop_front();
    lock.unlock();
    work();
    work = nullptr;  // what it owns may take a while to go, or post more
    lock.lock();
  }
  state.ended = true;
  state.changed.notify_all();
}

}  // namespace place_memory::panel
