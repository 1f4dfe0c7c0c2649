#include "node/map/rated_task.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <thread>

namespace place_memory::node {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::chrono::hours kForEver(1);

TEST(RatedTask, ARequestIsDoneAtOnce) {
  std::promise<void> done;
  RatedTask task(
      "task", [&done] { done.set_value(); }, kForEver);
  task.request();
  EXPECT_EQ(done.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

TEST(RatedTask, ManyRequestsAreFewAndTheLastOneCounts) {
  constexpr milliseconds kPause(50);
  std::atomic<int> newest{0};
  std::atomic<int> runs{0};
  std::promise<void> saw_last;
  const auto begin = steady_clock::now();
  {
    RatedTask task(
        "task",
        [&] {
          ++runs;
          if (newest == 10000) saw_last.set_value();
        },
        kPause);
    for (int i = 1; i < 10000; ++i) {
      newest = i;
      task.request();
    }
    newest = 10000;
    task.request();
    ASSERT_EQ(saw_last.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
  }
  EXPECT_LE(runs, 2 + (steady_clock::now() - begin) / kPause);
}

TEST(RatedTask, ATaskThatWaitsDoesNotPauseForLonger) {
  std::promise<void> first, second;
  std::atomic<int> runs{0};
  RatedTask task(
      "task",
      [&] {
        if (++runs == 1) {
          std::this_thread::sleep_for(milliseconds(500));  // 9.5 s of pause if it were work
          first.set_value();
        } else if (runs == 2) {
          second.set_value();
        }
      },
      milliseconds(1));
  task.request();
  first.get_future().wait();
  task.request();
  EXPECT_EQ(second.get_future().wait_for(std::chrono::seconds(8)), std::future_status::ready);
}

TEST(RatedTask, NothingBeginsAfterItsEnd) {
  std::atomic<int> runs{0};
  std::promise<void> first;
  {
    RatedTask task(
        "task",
        [&] {
          if (++runs == 1) first.set_value();
        },
        kForEver);
    task.request();
    first.get_future().wait();
    task.request();
  }
  EXPECT_EQ(runs, 1);
}

TEST(RatedTask, OneThatThrowsIsDoneAgainWhenItIsAskedFor) {
  std::atomic<int> runs{0};
  std::promise<void> second;
  RatedTask task(
      "task",
      [&] {
        if (++runs == 1) throw std::runtime_error("not this time");
        if (runs == 2) second.set_value();
      },
      milliseconds(1));
  const auto future = second.get_future();
  while (future.wait_for(milliseconds(1)) != std::future_status::ready) task.request();
  EXPECT_GE(runs, 2);
}

}  // namespace
}  // namespace place_memory::node
