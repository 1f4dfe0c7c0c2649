#include "core/map/link_odds.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace place_memory::core {
namespace {

using std::chrono::nanoseconds;
using std::chrono::seconds;

constexpr double kHalfLife = 1000.0;
constexpr double kExpected = 10.0;

Traversal traversal(int begin, int end, bool succeeded) {
  return {1, 2, seconds(begin), seconds(end), succeeded, ""};
}

double odds(const LinkDirection& direction, int now, double caution = 1.0) {
  return oddsThrough(direction, true, caution, seconds(now), kHalfLife);
}

TEST(LinkOdds, BeginAtThePriors) {
  EXPECT_DOUBLE_EQ(oddsThrough({}, true, 1.0, seconds(5), kHalfLife), 0.8);
  EXPECT_DOUBLE_EQ(oddsThrough({}, false, 1.0, seconds(5), kHalfLife), 2.0 / 3.0);
  EXPECT_GT(oddsThrough({}, true, 0.01, seconds(5), kHalfLife), 0.99);
}

TEST(LinkOdds, RiseWithWhatSucceedsAndFallWithWhatFails) {
  LinkDirection direction;
  direction = learned(direction, traversal(90, 100, true), kExpected, kHalfLife);
  EXPECT_DOUBLE_EQ(odds(direction, 100), 5.0 / 6.0);
  direction = learned(direction, traversal(90, 100, false), kExpected, kHalfLife);
  EXPECT_DOUBLE_EQ(odds(direction, 100), 5.0 / 7.0);
  EXPECT_EQ(direction.succeeded, 1U);
  EXPECT_EQ(direction.failed, 1U);
  EXPECT_EQ(direction.last, seconds(100));
}

TEST(LinkOdds, TimesFurtherApartThanNanosecondsCountAreTimesAllTheSame) {
  LinkDirection direction;
  direction.last = nanoseconds::min();
  direction.blocked = 3.0;
  direction = learned(direction, {1, 2, nanoseconds::min(), nanoseconds::max(), true, ""},
                      kExpected, kHalfLife);
  EXPECT_EQ(direction.blocked, 0.0);
  EXPECT_EQ(direction.through, 1.0);
  EXPECT_EQ(direction.time, 0.0) << "so long nobody drove";
  EXPECT_EQ(weightLeft(nanoseconds::max(), nanoseconds::min(), kHalfLife), 1.0);
}

TEST(LinkOdds, DriftBackToThePriorByHalvesAndNeverGetToZero) {
  LinkDirection direction;
  for (int i = 0; i < 1000; ++i) {
    direction = learned(direction, traversal(90, 100, false), kExpected, kHalfLife);
  }
  EXPECT_DOUBLE_EQ(odds(direction, 100), kLeastOdds);
  direction.blocked = 6.0;
  EXPECT_DOUBLE_EQ(odds(direction, 100), 4.0 / 11.0);
  EXPECT_DOUBLE_EQ(odds(direction, 1100), 4.0 / 8.0);
  EXPECT_NEAR(odds(direction, 1000000), 0.8, 1e-9);
  // A clock that was set back makes nothing older.
  EXPECT_DOUBLE_EQ(odds(direction, 50), 4.0 / 11.0);
}

TEST(LinkOdds, WhatIsOlderCountsForLessWhenMoreIsLearned) {
  LinkDirection direction = learned({}, traversal(90, 100, false), kExpected, kHalfLife);
  direction = learned(direction, traversal(1090, 1100, true), kExpected, kHalfLife);
  EXPECT_DOUBLE_EQ(direction.blocked, 0.5);
  EXPECT_DOUBLE_EQ(direction.through, 1.0);
  // One that is reported late counts as of the newest.
  direction = learned(direction, traversal(190, 200, true), kExpected, kHalfLife);
  EXPECT_DOUBLE_EQ(direction.through, 2.0);
  EXPECT_EQ(direction.last, seconds(1100));
}

TEST(LinkOdds, TimesAreMeansWithTheirSpread) {
  LinkDirection direction = learned({}, traversal(100, 108, true), kExpected, kHalfLife);
  EXPECT_DOUBLE_EQ(direction.time, 8.0);
  EXPECT_DOUBLE_EQ(direction.time_sigma, 0.0);
  direction = learned(direction, traversal(100, 112, true), kExpected, kHalfLife);
  EXPECT_DOUBLE_EQ(direction.time, 10.0);
  EXPECT_DOUBLE_EQ(direction.time_sigma, 2.0);
  direction = learned(direction, traversal(100, 130, false), kExpected, kHalfLife);
  EXPECT_DOUBLE_EQ(direction.lost_time, 30.0);
  EXPECT_DOUBLE_EQ(direction.time, 10.0);
}

TEST(LinkOdds, AWayWithABreakOrWithoutTimesTellsNothingOfTheTime) {
  LinkDirection direction = learned({}, traversal(100, 1000, true), kExpected, kHalfLife);
  direction = learned(direction, traversal(1000, 1000, true), kExpected, kHalfLife);
  EXPECT_EQ(direction.time, 0.0);
  EXPECT_EQ(direction.succeeded, 2U);
}

TEST(LinkOdds, ALinkThatWasNotTimedTakesAsLongAsTheOtherWayOrItsLength) {
  PlaceLink link;
  link.first_from_second = {3.0, 4.0, 0.0};
  const LinkLearningOptions options{kHalfLife, 0.5};
  EXPECT_DOUBLE_EQ(expectedTime(link, link.forward, options), 10.0);
  link.backward.time = 7.0;
  EXPECT_DOUBLE_EQ(expectedTime(link, link.forward, options), 7.0);
  link.forward.time = 6.0;
  EXPECT_DOUBLE_EQ(expectedTime(link, link.forward, options), 6.0);
  EXPECT_DOUBLE_EQ(expectedLoss(link.forward, 6.0), 6.0);
  link.forward.lost_time = 20.0;
  EXPECT_DOUBLE_EQ(expectedLoss(link.forward, 6.0), 20.0);
}

TEST(LinkOdds, ABlockedLinkHasTheLeastOddsAndIsFoundAgain) {
  LinkDirection direction;
  for (int i = 0; i < 9; ++i) {
    direction = learned(direction, traversal(90, 100, true), kExpected, kHalfLife);
  }
  direction = blockedNow(direction, true, seconds(200), kHalfLife);
  EXPECT_NEAR(odds(direction, 200), kLeastOdds, 1e-12);
  EXPECT_GT(odds(direction, 10200), 0.75);
  direction.forbidden = true;
  direction = unblocked(direction);
  EXPECT_GT(odds(direction, 200), 0.9);
  EXPECT_FALSE(direction.forbidden);
}

TEST(MapCaution, IsAsThePriorsHaveItWithoutExperience) {
  EXPECT_DOUBLE_EQ(MapCaution().value(), 1.0);
}

TEST(MapCaution, VanishesWhereNothingFailsAndStaysWhereAsMuchDoesAsIsExpected) {
  LinkDirection open, as_expected;
  open.through = 3.0;
  as_expected.through = 2.4;
  as_expected.blocked = 0.6;
  MapCaution calm, usual;
  for (int i = 0; i < 100; ++i) {
    calm.add(open, nanoseconds(0), kHalfLife);
    usual.add(as_expected, nanoseconds(0), kHalfLife);
  }
  EXPECT_LT(calm.value(), 0.02);
  EXPECT_NEAR(usual.value(), 1.0, 0.01);
}

TEST(MapCaution, OneDoorThatIsAlwaysClosedSaysLittleOfOthers) {
  LinkDirection open, closed;
  open.through = 3.0;
  closed.blocked = 1000.0;
  MapCaution caution;
  for (int i = 0; i < 100; ++i) caution.add(open, nanoseconds(0), kHalfLife);
  caution.add(closed, nanoseconds(0), kHalfLife);
  EXPECT_LT(caution.value(), 0.1);
}

}  // namespace
}  // namespace place_memory::core
