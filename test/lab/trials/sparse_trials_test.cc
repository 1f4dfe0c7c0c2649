#include "trials/sparse_trials.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/sensing/scan_echoes.h"

namespace place_memory::trials {
namespace {

/// Echoes in the grid of a scan, on average over the trials of a few seeds.
double meanEchoes(SparseKind kind) {
  double echoes = 0.0, scans = 0.0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const SparseTrials made = simulateSparse(kind, seed);
    for (const RecognitionTrial& trial : made.known.trials) {
      echoes += core::countEchoes(trial.readings, {made.known.cell_size});
      scans += 1.0;
    }
  }
  return echoes / scans;
}

class SparseTrialsTest : public testing::TestWithParam<SparseKind> {
 protected:
  const SparseKind kind_ = GetParam();
};

TEST_P(SparseTrialsTest, AreTheSameForTheSameSeedAndOthersForAnother) {
  const SparseTrials a = simulateSparse(kind_, 3), again = simulateSparse(kind_, 3);
  const SparseTrials other = simulateSparse(kind_, 4);
  ASSERT_EQ(a.known.trials.size(), again.known.trials.size());
  ASSERT_FALSE(a.known.trials.empty());
  const core::Pose2d& pose = a.known.trials.front().odom_from_scan;
  EXPECT_EQ(pose, again.known.trials.front().odom_from_scan);
  EXPECT_FALSE(pose == other.known.trials.front().odom_from_scan);
}

TEST_P(SparseTrialsTest, KnownScansHaveARightPlaceAndStrangersNone) {
  const SparseTrials made = simulateSparse(kind_, 5);
  ASSERT_GE(made.known.learned.size(), 3U);
  for (const RecognitionTrial& trial : made.known.trials) EXPECT_FALSE(trial.accept.empty());
  ASSERT_FALSE(made.strangers.empty());
  for (const RecognitionTrial& trial : made.strangers) EXPECT_TRUE(trial.accept.empty());
}

INSTANTIATE_TEST_SUITE_P(Kinds, SparseTrialsTest, testing::ValuesIn(kEverySparseKind));

TEST(SparseTrials, DeadRingsHearLittleOfWhatTheyLearned) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const SparseTrials made = simulateSparse(SparseKind::kDeadRing, seed);
    double learned = 0.0, heard = 0.0;
    for (const LearnedScan& scan : made.known.learned) {
      learned += core::countEchoes(scan.readings, {made.known.cell_size});
    }
    for (const RecognitionTrial& trial : made.known.trials) {
      heard += core::countEchoes(trial.readings, {made.known.cell_size});
    }
    EXPECT_LT(heard, 0.45 * learned) << seed;
  }
}

TEST(SparseTrials, OpenSpacesHoldFewerEchoesThanHalls) {
  EXPECT_LT(meanEchoes(SparseKind::kOpenSpace), meanEchoes(SparseKind::kHall));
}

TEST(SparseTrials, EveryKindHasAName) {
  EXPECT_EQ(nameOf(SparseKind::kOpenSpace), std::string("open space"));
  EXPECT_EQ(nameOf(SparseKind::kFewSensors), std::string("few sensors"));
}

}  // namespace
}  // namespace place_memory::trials
