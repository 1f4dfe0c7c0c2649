#include "core/sensing/recent_count.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(RecentCount, IsNothingAtFirst) {
  const RecentCount count;
  EXPECT_EQ(count.at(seconds(0)), 0U);
  EXPECT_EQ(count.at(hours(1)), 0U);
}

TEST(RecentCount, CountsTheLastTenSeconds) {
  RecentCount count;
  for (int i = 0; i < 300; ++i) count.add(milliseconds(100 * i));
  EXPECT_EQ(count.at(milliseconds(29999)), 100U);
}

TEST(RecentCount, ForgetsSecondBySecond) {
  RecentCount count;
  count.add(seconds(5));
  count.add(seconds(5));
  count.add(seconds(8));
  EXPECT_EQ(count.at(seconds(14)), 3U);
  EXPECT_EQ(count.at(seconds(15)), 1U);
  EXPECT_EQ(count.at(seconds(17)), 1U);
  EXPECT_EQ(count.at(seconds(18)), 0U);
}

TEST(RecentCount, AGoodHourDoesNotHideWhatFollows) {
  RecentCount count;
  for (int i = 0; i < 3600; ++i) count.add(seconds(i));
  EXPECT_EQ(count.at(hours(1)), 9U);
  EXPECT_EQ(count.at(hours(2)), 0U);
  count.add(hours(2));
  EXPECT_EQ(count.at(hours(2)), 1U) << "nothing of before is left in the ring";
}

TEST(RecentCount, TheFirstSecondsCountToo) {
  RecentCount count;
  count.add(seconds(0));
  EXPECT_EQ(count.at(seconds(0)), 1U);
  EXPECT_EQ(count.at(seconds(9)), 1U);
  EXPECT_EQ(count.at(seconds(10)), 0U);
}

}  // namespace
}  // namespace place_memory::core
