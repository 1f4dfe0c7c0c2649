#include "core/mapping/lost_estimate.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

TEST(LostEstimate, AMissNowAndThenIsNoLoss) {
  LostEstimate lost;
  for (int i = 0; i < 400; ++i) {
    lost.update(i % 7 == 3 ? ScanWitness::kMisses : ScanWitness::kAgrees, 0.5);
    EXPECT_LT(lost.probability(), 0.1);
  }
}

TEST(LostEstimate, MissesInARowAreOne) {
  LostEstimate lost;
  for (int i = 0; i < 20; ++i) lost.update(ScanWitness::kAgrees, 0.5);
  int misses = 0;
  while (lost.probability() < 0.95 && misses < 50) {
    lost.update(ScanWitness::kMisses, 0.5);
    ++misses;
  }
  EXPECT_GE(misses, 5);
  EXPECT_LE(misses, 8);
}

TEST(LostEstimate, OnNewGroundItHardlyRises) {
  LostEstimate lost;
  for (int i = 0; i < 100; ++i) lost.update(ScanWitness::kSilent, 0.5);
  EXPECT_GT(lost.probability(), 0.01);
  EXPECT_LT(lost.probability(), 0.1);
}

TEST(LostEstimate, NewGroundThatLooksLikeKnownGroundIsNeverASureLoss) {
  LostEstimate lost;
  for (int i = 0; i < 200; ++i) lost.update(ScanWitness::kDoubts, 0.5);
  EXPECT_GT(lost.probability(), 0.5);
  EXPECT_LT(lost.probability(), 0.9);
}

TEST(LostEstimate, FoundAgainItSaysSo) {
  LostEstimate lost;
  lost.set(0.9);
  for (int i = 0; i < 4; ++i) lost.update(ScanWitness::kAgrees, 0.5);
  EXPECT_LT(lost.probability(), 0.01);
}

}  // namespace
}  // namespace place_memory::core
