#ifndef PLACE_MEMORY_RVIZ_BACKGROUND_THREAD_H
#define PLACE_MEMORY_RVIZ_BACKGROUND_THREAD_H

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace place_memory::panel {

/// Does one piece of work after the other, in the order in which they were posted, so that whoever
/// posts never waits: rviz's own thread draws.
class BackgroundThread {
 public:
  using Work = std::function<void()>;  ///< must not throw

  BackgroundThread();
  BackgroundThread(const BackgroundThread&) = delete;
  BackgroundThread& operator=(const BackgroundThread&) = delete;

  /// Waits until all that was posted is done, but not for long: a machine that is gone from the
  /// network holds a connection for minutes, and rviz is to close all the same. Work that hangs so
  /// is left behind, and must own what it uses.
  ~BackgroundThread();

  void post(Work work);

 private:
  struct State {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<Work> work;
    bool stop = false;
    bool ended = false;
  };

  static void run(State& state);

  std::shared_ptr<State> state_ = std::make_shared<State>();
  std::thread thread_;
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_BACKGROUND_THREAD_H
