#include "core/sensing/listening_end.h"

#include <gtest/gtest.h>

#include "core/sensing/sweep_fixture.h"

namespace place_memory::core {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds kStart(100000);

SweepBuilder standing() { return {1, kStep, {}, true}; }

TEST(ListeningEnd, ComesWithTheLastSensorsTurn) {
  ListeningEnd end(kStart, 2);
  SweepBuilder sweep = standing();
  sweep.add(located(kStart, 1, {}));
  sweep.add(located(kStart, 2, {}));
  EXPECT_FALSE(end.update(kStart, sweep)) << "another sensor may still come";
  sweep.add(located(kStart, 1, {}));
  EXPECT_TRUE(end.update(kStart, sweep));
}

TEST(ListeningEnd, ComesNotBeforeThereAreReadingsEnough) {
  ListeningEnd end(kStart, 4);
  SweepBuilder sweep = standing();
  for (int i = 0; i < 3; ++i) sweep.add(located(kStart, 1, {}));
  EXPECT_TRUE(sweep.coverage().done());
  EXPECT_FALSE(end.update(kStart, sweep));
  EXPECT_FALSE(end.update(kStart + seconds(10), sweep));
  sweep.add(located(kStart + seconds(10), 1, {}));
  EXPECT_TRUE(end.update(kStart + seconds(10), sweep));
}

TEST(ListeningEnd, ComesAfterHalfASecondOfSilence) {
  ListeningEnd end(kStart, 1);
  SweepBuilder sweep = standing();
  sweep.add(located(kStart, 1, {}));
  EXPECT_FALSE(end.update(kStart, sweep));
  EXPECT_FALSE(end.update(kStart + milliseconds(500), sweep));
  EXPECT_TRUE(end.update(kStart + milliseconds(501), sweep));
}

TEST(ListeningEnd, ASilenceIsTwiceAsLongAsEverBefore) {
  ListeningEnd end(kStart, 1);
  SweepBuilder sweep = {1, kStep, {1, 2, 3}, true};
  sweep.add(located(kStart, 1, {}));
  end.update(kStart, sweep);
  sweep.add(located(kStart + milliseconds(800), 2, {}));
  EXPECT_FALSE(end.update(kStart + milliseconds(800), sweep));
  EXPECT_FALSE(end.update(kStart + milliseconds(2400), sweep));
  EXPECT_TRUE(end.update(kStart + milliseconds(2401), sweep));
}

TEST(ListeningEnd, SilenceDoesNotEndASweepWhoseHeadingsAreNotSensed) {
  ListeningEnd end(kStart, 1);
  SweepBuilder sweep = {2, kStep, {1, 2}, true};
  sweep.add(located(kStart, 1, {}));
  end.update(kStart, sweep);
  EXPECT_FALSE(end.update(kStart + seconds(30), sweep));
  sweep.add(located(kStart + seconds(30), 1, {0, 0, kStep}));
  EXPECT_FALSE(end.update(kStart + seconds(30), sweep)) << "the silence is over";
}

}  // namespace
}  // namespace place_memory::core
