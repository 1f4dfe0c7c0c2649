#include "support/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace place_memory::support {
namespace {

TEST(ParallelFor, CallsEachOnce) {
  for (const std::size_t threads : {0U, 1U, 3U, 40U}) {
    for (const std::size_t count : {0U, 1U, 2U, 100U}) {
      std::vector<std::atomic<int>> calls(count);
      parallelFor(
          count, [&](std::size_t i) { ++calls[i]; }, threads);
      for (const std::atomic<int>& times : calls) EXPECT_EQ(times, 1);
    }
  }
}

TEST(ParallelFor, ThrowsHereWhatWasThrownThereAndBeginsNoMore) {
  for (const std::size_t threads : {1U, 2U, 5U}) {
    std::atomic<std::size_t> begun{0};
    const auto fourth_fails = [&](std::size_t i) {
      ++begun;
      if (i == 3) throw std::runtime_error("the fourth");
    };
    try {
      parallelFor(100000, fourth_fails, threads);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), "the fourth");
    }
    EXPECT_LT(begun, 100000U);
  }
}

TEST(ParallelFor, TellsHowManyAreDoneOneCallAtATime) {
  std::vector<std::size_t> told;
  parallelFor(
      50, [](std::size_t) {}, 4, [&](std::size_t done) { told.push_back(done); });
  ASSERT_EQ(told.size(), 50U);
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i], i + 1);
}

TEST(ParallelFor, PassesOnWhatTheTellingThrows) {
  const auto refuses = [](std::size_t) { throw std::runtime_error("no"); };
  EXPECT_THROW(parallelFor(
                   5, [](std::size_t) {}, 2, refuses),
               std::runtime_error);
}

}  // namespace
}  // namespace place_memory::support
