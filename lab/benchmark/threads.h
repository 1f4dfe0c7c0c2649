#ifndef PLACE_MEMORY_BENCHMARK_THREADS_H
#define PLACE_MEMORY_BENCHMARK_THREADS_H

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace place_memory::measure {

/// Calls `work(0)` to `work(count - 1)`, on every core. What a call throws is thrown again.
template <typename Work>
void inThreads(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(run);
  run();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_THREADS_H
