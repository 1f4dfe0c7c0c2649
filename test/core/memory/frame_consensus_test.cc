#include "core/memory/frame_consensus.h"

#include <gtest/gtest.h>

#include <random>

namespace place_memory::core {
namespace {

const Pose2d kFrame{20.0, -3.0, 2.0};

/// Place `id`, seen where it is by kFrame but for the error.
FramePair seen(PlaceId id, const Pose2d& error = {}, SessionId session = 1) {
  const Pose2d from{2.0 * static_cast<double>(id), static_cast<double>(id % 3), 0.5};
  return {session, kFrame * from * error, from, id, false};
}

TEST(FrameConsensus, IsFoundAmongOutliersAndFitsBetterThanEachPair) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<FramePair> pairs;
  for (PlaceId id = 1; id <= 10; ++id) {
    pairs.push_back(seen(id, {noise(random), noise(random), noise(random)}));
  }
  pairs.push_back(seen(11, {5.0, 3.0, 0.0}));
  pairs.push_back(seen(12, {-4.0, 0.0, 1.0}));
  const auto consensus = frameConsensus(pairs, 3);
  ASSERT_TRUE(consensus);
  EXPECT_NEAR(consensus->into_from_from.x, kFrame.x, 0.1);
  EXPECT_NEAR(consensus->into_from_from.y, kFrame.y, 0.1);
  EXPECT_NEAR(wrapAngle(consensus->into_from_from.yaw - kFrame.yaw), 0.0, 0.02);
}

TEST(FrameConsensus, NeedsEnoughPlacesNotPairs) {
  EXPECT_FALSE(frameConsensus({}, 1));
  EXPECT_FALSE(frameConsensus({seen(1), seen(2)}, 3));
  EXPECT_FALSE(frameConsensus({seen(1), seen(1), seen(1)}, 3));
  EXPECT_TRUE(frameConsensus({seen(1), seen(2), seen(3)}, 3));
  EXPECT_TRUE(frameConsensus({seen(1)}, 1));
}

TEST(FrameConsensus, OfTwoOpinionsThatAreNearlyAsStrongIsNone) {
  const Pose2d aside{6.0, 0.0, 0.0};
  std::vector<FramePair> pairs{seen(1), seen(2), seen(3)};
  pairs.push_back(seen(4, aside));
  EXPECT_TRUE(frameConsensus(pairs, 3));
  pairs.push_back(seen(5, aside));
  EXPECT_FALSE(frameConsensus(pairs, 3));
}

TEST(FrameConsensus, PairsThatAreSureCountFully) {
  FramePair sure = seen(1);
  sure.sure = true;
  EXPECT_TRUE(frameConsensus({sure}, 3));
}

TEST(FrameConsensus, FramesOfSeveralSessionsAreNotMixed) {
  EXPECT_FALSE(frameConsensus({seen(1), seen(2), seen(3, {}, 2)}, 3));
  const auto consensus = frameConsensus({seen(1, {}, 2), seen(2, {}, 2), seen(3, {}, 2)}, 3);
  ASSERT_TRUE(consensus);
  EXPECT_EQ(consensus->session, 2);
}

}  // namespace
}  // namespace place_memory::core
