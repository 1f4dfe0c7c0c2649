#include "core/sensing/heading_history.h"

#include <gtest/gtest.h>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(HeadingHistory, IsEmptyAtFirst) {
  const HeadingHistory history(seconds(1));
  EXPECT_FALSE(history.at(seconds(0)));
  EXPECT_FALSE(history.newest());
}

TEST(HeadingHistory, GivesASampleAtItsOwnStamp) {
  HeadingHistory history(seconds(1));
  history.add(seconds(10), 0.5);
  EXPECT_NEAR(history.at(seconds(10)).value(), 0.5, 1e-12);
}

TEST(HeadingHistory, InterpolatesInProportionToTime) {
  HeadingHistory history(seconds(1));
  history.add(milliseconds(10000), 0.2);
  history.add(milliseconds(10400), 0.6);
  EXPECT_NEAR(history.at(milliseconds(10100)).value(), 0.3, 1e-12);
}

TEST(HeadingHistory, InterpolatesTheShorterWayAroundSouth) {
  HeadingHistory history(seconds(1));
  history.add(milliseconds(0), kPi - 0.1);
  history.add(milliseconds(100), -kPi + 0.1);
  EXPECT_NEAR(history.at(milliseconds(25)).value(), kPi - 0.05, 1e-12);
  EXPECT_NEAR(history.at(milliseconds(75)).value(), -kPi + 0.05, 1e-12);
}

TEST(HeadingHistory, HoldsTheNewestSampleUntilItIsTooOld) {
  HeadingHistory history(milliseconds(500));
  history.add(seconds(10), 0.5);
  EXPECT_NEAR(history.at(milliseconds(10500)).value(), 0.5, 1e-12);
  EXPECT_FALSE(history.at(milliseconds(10501)));
}

TEST(HeadingHistory, KnowsNothingBeforeItsFirstSample) {
  HeadingHistory history(seconds(1));
  history.add(seconds(10), 0.5);
  EXPECT_FALSE(history.at(milliseconds(9999)));
}

TEST(HeadingHistory, DoesNotBridgeAGap) {
  HeadingHistory history(milliseconds(500));
  history.add(seconds(10), 0.0);
  history.add(seconds(12), 1.0);
  EXPECT_FALSE(history.at(seconds(11)));
  EXPECT_FALSE(history.at(milliseconds(10200))) << "the sample after it is 1.8 s away";
}

TEST(HeadingHistory, DropsALateSample) {
  HeadingHistory history(seconds(5));
  history.add(seconds(10), 0.0);
  history.add(seconds(11), 1.0);
  EXPECT_EQ(history.add(milliseconds(10500), 3.0), TimeOrder::kLate);
  EXPECT_NEAR(history.at(milliseconds(10500)).value(), 0.5, 1e-12);
}

TEST(HeadingHistory, LeavesAStaleSampleOut) {
  HeadingHistory history(seconds(5));
  history.add(seconds(100), 1.0);
  EXPECT_EQ(history.add(seconds(10), 2.0), TimeOrder::kBackwards);
  EXPECT_EQ(history.size(), 1U);
  EXPECT_NEAR(history.at(seconds(100)).value(), 1.0, 1e-12);
  EXPECT_FALSE(history.at(seconds(10)));
  EXPECT_EQ(history.add(seconds(101), 1.2), TimeOrder::kForward);
  EXPECT_NEAR(history.at(milliseconds(100500)).value(), 1.1, 1e-12);
}

TEST(HeadingHistory, ReplacesASampleOfTheSameStamp) {
  HeadingHistory history(seconds(1));
  history.add(seconds(10), 0.1);
  history.add(seconds(10), 0.3);
  EXPECT_EQ(history.size(), 1U);
  EXPECT_NEAR(history.at(seconds(10)).value(), 0.3, 1e-12);
}

TEST(HeadingHistory, KeepsABoundedNumberOfSamples) {
  HeadingHistory history(seconds(1));
  const auto stamp = [](std::size_t i) { return milliseconds(10 * static_cast<int>(i)); };
  const std::size_t count = HeadingHistory::kMaxSamples + 10;
  for (std::size_t i = 0; i < count; ++i) history.add(stamp(i), 0.0);
  EXPECT_EQ(history.size(), HeadingHistory::kMaxSamples);
  EXPECT_FALSE(history.at(stamp(9)));
  EXPECT_TRUE(history.at(stamp(10)));
}

}  // namespace
}  // namespace place_memory::core
