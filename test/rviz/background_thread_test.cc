#include "rviz/background_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <vector>

namespace place_memory::panel {
namespace {

TEST(BackgroundThread, WorkIsDoneInItsOrderBeforeItEnds) {
  std::vector<int> done;
  {
    BackgroundThread thread;
    for (int i = 0; i < 100; ++i) thread.post([i, &done] { done.push_back(i); });
  }
  ASSERT_EQ(done.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(BackgroundThread, WorkThatHangsIsLeftBehind) {
  auto release = std::make_shared<std::promise<void>>();
  auto left = std::make_shared<std::promise<void>>();
  const auto begin = std::chrono::steady_clock::now();
  {
    BackgroundThread thread;
    thread.post([released = release->get_future().share(), left] {
      released.wait();
      left->set_value();
    });
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  std::future<void> over = left->get_future();
  EXPECT_EQ(over.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  release->set_value();
  over.wait();  // what it uses is its own
}

}  // namespace
}  // namespace place_memory::panel
