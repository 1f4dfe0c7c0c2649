#include "support/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace place_memory::support {
namespace {

constexpr std::size_t kThreads[] = {1, 2, 5};
constexpr std::size_t kTasks[] = {0, 1, 2, 3, 100};

TEST(WorkerPool, DoesEachTaskOnce) {
  for (const std::size_t threads : kThreads) {
    WorkerPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    for (const std::size_t tasks : kTasks) {
      std::vector<std::atomic<int>> done(tasks);
      pool.run(tasks, [&](std::size_t i) { ++done[i]; });
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    }
  }
}

TEST(WorkerPool, PassesOnWhatATaskThrowsAndGoesOnWorking) {
  for (const std::size_t threads : kThreads) {
    WorkerPool pool(threads);
    const auto third_fails = [](std::size_t i) {
      if (i == 3) throw std::runtime_error("third");
    };
    try {
      pool.run(100, third_fails);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), "third");
    }
    std::atomic<int> done{0};
    pool.run(10, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 10);
  }
}

TEST(WorkerPool, BeginsNoTaskOnceThePollThrows) {
  for (const std::size_t threads : kThreads) {
    WorkerPool pool(threads);
    std::atomic<int> done{0};
    const auto cancel = [] { throw std::runtime_error("cancelled"); };
    EXPECT_THROW(pool.run(
                     1000000, [&](std::size_t) { ++done; }, cancel),
                 std::runtime_error);
    EXPECT_LT(done, 1000000);
  }
}

TEST(WorkerPool, PollsInTheThreadOfTheCaller) {
  for (const std::size_t threads : kThreads) {
    WorkerPool pool(threads);
    const std::thread::id caller = std::this_thread::get_id();
    int polls = 0;
    pool.run(
        50, [](std::size_t) {},
        [&] {
          EXPECT_EQ(std::this_thread::get_id(), caller);
          ++polls;
        });
    EXPECT_GE(polls, 1);
  }
}

TEST(WorkerPool, ServesSeveralCallersAtOnce) {
  WorkerPool pool(3);
  std::atomic<int> done{0};
  std::vector<std::thread> callers;
  for (int i = 0; i < 4; ++i) {
    callers.emplace_back([&] {
      for (int round = 0; round < 50; ++round) pool.run(20, [&](std::size_t) { ++done; });
    });
  }
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(done, 4 * 50 * 20);
}

TEST(WorkerPool, ATaskMayRunTasksOfItsOwn) {
  WorkerPool pool(2);
  std::atomic<int> done{0};
  pool.run(4, [&](std::size_t) { pool.run(5, [&](std::size_t) { ++done; }); });
  EXPECT_EQ(done, 20);
}

}  // namespace
}  // namespace place_memory::support
