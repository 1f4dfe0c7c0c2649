#include "core/sensing/sweep_coverage.h"

#include <gtest/gtest.h>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {
namespace {

constexpr double kStep = kPi / 90.0;
constexpr SensorId kSlow = 77;

void addSet(SweepCoverage& coverage, int sensors, double yaw) {
  for (int k = 0; k < sensors; ++k) coverage.add(static_cast<SensorId>(k), yaw);
}

TEST(SweepCoverage, StartsWithNothing) {
  const SweepCoverage coverage(11, kStep);
  EXPECT_EQ(coverage.headings(), 0);
  EXPECT_EQ(coverage.completed(), 0);
  EXPECT_EQ(coverage.fraction(), 0.0);
}

TEST(SweepCoverage, EndsWithTheLastSetOfTheSweep) {
  SweepCoverage coverage(11, kStep);
  for (int set = 0; set < 11; ++set) {
    EXPECT_FALSE(coverage.done()) << set;
    addSet(coverage, 16, 3.0 + set * kStep);  // passes south
  }
  EXPECT_TRUE(coverage.done());
  EXPECT_EQ(coverage.headings(), 11);
  EXPECT_EQ(coverage.fraction(), 1.0);
}

TEST(SweepCoverage, EndsWhenTheRobotTurnsOnAlthoughASensorMissedTheLastHeading) {
  SweepCoverage coverage(3, kStep);
  addSet(coverage, 4, 0.0);
  addSet(coverage, 4, -kStep);
  addSet(coverage, 3, -2.0 * kStep);
  EXPECT_FALSE(coverage.done());
  addSet(coverage, 1, -3.0 * kStep);
  EXPECT_TRUE(coverage.done());
}

TEST(SweepCoverage, AtAStandstillTakesEverySensorOnce) {
  SweepCoverage coverage(1, kStep);
  addSet(coverage, 16, 0.3);
  EXPECT_FALSE(coverage.done()) << "another sensor may still come";
  addSet(coverage, 1, 0.3);
  EXPECT_TRUE(coverage.done());
}

TEST(SweepCoverage, WaitsForTheSlowSensorsThatItKnows) {
  SweepCoverage coverage(1, kStep, {0, 1, kSlow});
  for (int set = 0; set < 10; ++set) addSet(coverage, 2, 0.0);
  EXPECT_FALSE(coverage.done());
  coverage.add(kSlow, 0.0);
  EXPECT_TRUE(coverage.done());
}

TEST(SweepCoverage, WaitsAtEachHeadingForTheSensorsHeardBefore) {
  SweepCoverage coverage(2, kStep);
  addSet(coverage, 3, 0.0);
  for (int set = 0; set < 10; ++set) addSet(coverage, 2, kStep);
  EXPECT_FALSE(coverage.done());
  addSet(coverage, 3, kStep);
  EXPECT_TRUE(coverage.done());
}

TEST(SweepCoverage, ASensorWhoseReadingsCannotBeUsedHasHadItsTurn) {
  SweepCoverage coverage(1, kStep, {0, kSlow});
  coverage.skip(kSlow);
  EXPECT_EQ(coverage.headings(), 0) << "no reading was used";
  addSet(coverage, 1, 0.0);
  addSet(coverage, 1, 0.0);
  EXPECT_FALSE(coverage.done());
  coverage.skip(kSlow);
  EXPECT_TRUE(coverage.done());
}

TEST(SweepCoverage, ASensorThatIsNotWaitedForChangesNothingWhereItIsSkipped) {
  SweepCoverage coverage(1, kStep);
  addSet(coverage, 2, 0.0);
  for (int i = 0; i < 3; ++i) coverage.skip(kSlow);
  EXPECT_FALSE(coverage.done()) << "a sensor that is unknown has no turn";
  addSet(coverage, 1, 0.0);
  EXPECT_TRUE(coverage.done()) << "and is not waited for";
}

TEST(SweepCoverage, BeforeTheFirstReadingNobodyHasHadATurn) {
  SweepCoverage coverage(1, kStep, {0, kSlow});
  coverage.skip(kSlow);
  coverage.skip(kSlow);
  addSet(coverage, 1, 0.0);
  EXPECT_FALSE(coverage.done());
}

TEST(SweepCoverage, TwentyTurnsOfAnotherAreTheEndOfWaitingAndNineteenAreNot) {
  SweepCoverage coverage(1, kStep, {0, kSlow});
  for (int set = 0; set < 19; ++set) addSet(coverage, 1, 0.0);
  EXPECT_FALSE(coverage.done());
  addSet(coverage, 1, 0.0);
  EXPECT_TRUE(coverage.done());
}

TEST(SweepCoverage, DoesNotWaitForEverForASensorThatFellSilent) {
  SweepCoverage coverage(2, kStep);
  addSet(coverage, 3, 0.0);
  for (int set = 0; set < 20; ++set) addSet(coverage, 2, kStep);
  EXPECT_TRUE(coverage.done());
}

TEST(SweepCoverage, NeverEndsWhereNothingTurnsTheRobot) {
  SweepCoverage coverage(11, kStep);
  for (int set = 0; set < 100; ++set) addSet(coverage, 4, 0.001 * (set % 3));
  EXPECT_FALSE(coverage.done());
  EXPECT_EQ(coverage.headings(), 1);
}

TEST(SweepCoverage, FullTurnOfOneSensorHasEachHeadingOnce) {
  SweepCoverage coverage(1000, kPi / 36.0);
  EXPECT_EQ(coverage.target(), 72);
  for (int i = 0; i < 72; ++i) {
    EXPECT_FALSE(coverage.done()) << i;
    addSet(coverage, 1, i * kPi / 36.0);
  }
  EXPECT_TRUE(coverage.done());
  addSet(coverage, 1, 2.0 * kPi);
  EXPECT_EQ(coverage.headings(), 72);
}

}  // namespace
}  // namespace place_memory::core
