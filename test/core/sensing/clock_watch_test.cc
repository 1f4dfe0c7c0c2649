#include "core/sensing/clock_watch.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

constexpr nanoseconds kSteady{0};
constexpr nanoseconds kEndOfTime = seconds(4294967295);

class ClockWatchTest : public testing::Test {
 protected:
  bool jumps(nanoseconds now) { return watch_.jumped(watch_.observe(now, kSteady)); }

  ClockWatch watch_{seconds(1)};
};

TEST_F(ClockWatchTest, AClockThatGoesForwardDoesNotJump) {
  for (int second = 0; second < 5; ++second) {
    EXPECT_EQ(watch_.observe(seconds(second), kSteady), nanoseconds(0));
  }
  EXPECT_EQ(watch_.observe(kEndOfTime, kSteady), nanoseconds(0));
}

TEST_F(ClockWatchTest, AStepBackUpToTheToleranceIsNoJump) {
  EXPECT_FALSE(jumps(seconds(100)));
  EXPECT_EQ(watch_.observe(milliseconds(99900), kSteady), milliseconds(100));
  EXPECT_FALSE(jumps(milliseconds(99000)));
  EXPECT_TRUE(jumps(milliseconds(99000) - nanoseconds(1)));
}

TEST_F(ClockWatchTest, SmallStepsAddUpToAJump) {
  EXPECT_FALSE(jumps(seconds(100)));
  EXPECT_FALSE(jumps(milliseconds(99400)));
  EXPECT_TRUE(jumps(milliseconds(98800)));
}

TEST_F(ClockWatchTest, TwoSourcesOfTimeMayTakeTurns) {
  for (int i = 0; i < 50; ++i) {
    EXPECT_FALSE(jumps(milliseconds(100000 + 100 * i))) << i;
    EXPECT_FALSE(jumps(milliseconds(99500 + 100 * i))) << i;
  }
}

TEST_F(ClockWatchTest, AfterAJumpItGoesOnFromThere) {
  EXPECT_FALSE(jumps(kEndOfTime));
  EXPECT_EQ(watch_.observe(seconds(100), kSteady), kEndOfTime - seconds(100));
  EXPECT_FALSE(jumps(seconds(101)));
  EXPECT_TRUE(jumps(seconds(50)));
}

TEST_F(ClockWatchTest, SaysHowLongTheClockStands) {
  watch_.observe(seconds(5), seconds(1000));
  watch_.observe(seconds(5), seconds(1003));
  EXPECT_EQ(watch_.standing(seconds(1003)), seconds(3));
  watch_.observe(seconds(6), seconds(1004));
  EXPECT_EQ(watch_.standing(seconds(1004)), seconds(0));
  watch_.restart(seconds(1006));
  EXPECT_EQ(watch_.standing(seconds(1007)), seconds(1));
}

TEST(ForwardTime, PassesWithTheClock) {
  ForwardTime time;
  time.observe(seconds(1000));
  EXPECT_EQ(time.passed(), seconds(0)) << "when it began does not matter";
  time.observe(milliseconds(1000500));
  time.observe(milliseconds(1001500));
  EXPECT_EQ(time.passed(), milliseconds(1500));
}

TEST(ForwardTime, DoesNotGoBackAndTakesNoLeap) {
  ForwardTime time;
  time.observe(seconds(1000));
  time.observe(seconds(10));
  EXPECT_EQ(time.passed(), seconds(0));
  time.observe(seconds(12));
  EXPECT_EQ(time.passed(), seconds(2));
  time.observe(kEndOfTime);
  EXPECT_EQ(time.passed(), seconds(2) + ForwardTime::kLongestStep);
}

}  // namespace
}  // namespace place_memory::core
