#include "support/turn_mutex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace place_memory::support {
namespace {

TEST(TurnMutex, OneThreadAtATimeHasIt) {
  TurnMutex mutex;
  int count = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int turn = 0; turn < 5000; ++turn) {
        const std::lock_guard<TurnMutex> lock(mutex);
        ++count;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(count, 20000);
}

// Which lets it go for a moment now and then.
TEST(TurnMutex, ABusyThreadKeepsNobodyOut) {
  constexpr std::size_t kTurns = 100;
  TurnMutex mutex;
  std::atomic<int> busy_turns{0};
  std::atomic<bool> is_over{false};
  std::thread busy([&] {
    while (!is_over) {
      const std::lock_guard<TurnMutex> lock(mutex);
      ++busy_turns;
      for (volatile int work = 0; work < 20000; ++work) {
      }
    }
  });
  std::vector<int> waited;  // turns of the busy one, before each of this one
  while (waited.size() < kTurns) {
    const int before = busy_turns;
    const std::lock_guard<TurnMutex> lock(mutex);
    waited.push_back(busy_turns - before);
  }
  is_over = true;
  busy.join();
  // But for the times when this thread was put aside before it came to wait.
  std::sort(waited.begin(), waited.end());
  EXPECT_LE(waited[kTurns / 2], 2);
}

}  // namespace
}  // namespace place_memory::support
