#ifndef PLACE_MEMORY_SUPPORT_TURN_MUTEX_H
#define PLACE_MEMORY_SUPPORT_TURN_MUTEX_H

#include <mutex>

namespace place_memory::support {

/// A mutex that goes to who waits for it before it comes back to who had it: with a plain one a
/// thread that lets it go and takes it again at once may keep all others out for ever.
class TurnMutex {
 public:
  void lock() {
    const std::lock_guard<std::mutex> entry(entry_);
    mutex_.lock();
  }
  void unlock() { mutex_.unlock(); }

 private:
  std::mutex entry_;  ///< held by who comes next
  std::mutex mutex_;
};

}  // namespace place_memory::support

#endif  // PLACE_MEMORY_SUPPORT_TURN_MUTEX_H
