#include "core/mapping/lost_estimate.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

/// One scan, half a metre on.
void update(LostEstimate& lost, ScanWitness witness, Continuity readings = Continuity::kUnseen) {
  lost.drive({readings, CompassTurn::kUnseen, 0.0}, 0.5);
  lost.see(witness);
}

TEST(LostEstimate, AMissNowAndThenIsNoLoss) {
  LostEstimate lost;
  for (int i = 0; i < 400; ++i) {
    update(lost, i % 7 == 3 ? ScanWitness::kMisses : ScanWitness::kAgrees);
    EXPECT_LT(lost.probability(), 0.1);
  }
}

TEST(LostEstimate, MissesInARowAreOne) {
  LostEstimate lost;
  for (int i = 0; i < 20; ++i) update(lost, ScanWitness::kAgrees);
  int misses = 0;
  while (lost.probability() < 0.95 && misses < 50) {
    update(lost, ScanWitness::kMisses);
    ++misses;
  }
  EXPECT_GE(misses, 5);
  EXPECT_LE(misses, 9);
}

TEST(LostEstimate, WhereNothingIsSeenItHardlyRises) {
  LostEstimate lost;
  for (int i = 0; i < 100; ++i) update(lost, ScanWitness::kSilent);
  EXPECT_GT(lost.probability(), 0.01);
  EXPECT_LT(lost.probability(), 0.1);
}

TEST(LostEstimate, WhereReadingsGoOnItDoesNot) {
  LostEstimate lost;
  for (int i = 0; i < 100; ++i) update(lost, ScanWitness::kSilent, Continuity::kGoesOn);
  EXPECT_LT(lost.probability(), 0.01);
}

TEST(LostEstimate, ABreakOnNewGroundIsALossUntilScansSayOtherwise) {
  LostEstimate lost;
  for (int i = 0; i < 20; ++i) update(lost, ScanWitness::kSilent, Continuity::kGoesOn);
  EXPECT_GT(lost.drive({Continuity::kSurelyBreaks, CompassTurn::kUnseen, 0.0}, 0.5), 0.5);
  for (int i = 0; i < 20; ++i) update(lost, ScanWitness::kSilent, Continuity::kGoesOn);
  EXPECT_GT(lost.probability(), 0.5);
  for (int i = 0; i < 3; ++i) update(lost, ScanWitness::kAgrees, Continuity::kGoesOn);
  EXPECT_LT(lost.probability(), 0.2);
}

TEST(LostEstimate, NewGroundThatLooksLikeKnownGroundIsNeverASureLoss) {
  LostEstimate lost;
  for (int i = 0; i < 200; ++i) update(lost, ScanWitness::kDoubts);
  EXPECT_GT(lost.probability(), 0.5);
  EXPECT_LT(lost.probability(), 0.9);
}

TEST(LostEstimate, FoundAgainItSaysSo) {
  LostEstimate lost;
  lost.set(0.9);
  for (int i = 0; i < 4; ++i) update(lost, ScanWitness::kAgrees);
  EXPECT_LT(lost.probability(), 0.01);
}

}  // namespace
}  // namespace place_memory::core
