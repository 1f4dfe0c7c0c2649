#include "training/training_worlds.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "place_memory/config/match_preset.h"
#include "training/calibration_fit.h"
#include "training/preset_file.h"
#include "training/ranking_fit.h"
#include "training/sparse_lists.h"
#include "training/strangers.h"

namespace place_memory::training {
namespace {

TEST(TrainingSet, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const trials::TrialSet a = trainingSet(7), again = trainingSet(7), b = trainingSet(8);
  ASSERT_EQ(a.trials.size(), again.trials.size());
  EXPECT_EQ(a.trials.front().readings.front().range, again.trials.front().readings.front().range);
  EXPECT_EQ(a.name, again.name);
  EXPECT_NE(a.name, b.name);
}

TEST(Strangers, HaveNoRightPlaceAndNoneNear) {
  const trials::TrialSet set = trainingSet(3);
  const core::SonarModel model{{}};
  const auto metric = config::loadPreset("evidence").metric;
  const auto known = alignAll(set, model, metric);
  ASSERT_EQ(known.size(), set.trials.size());
  for (const CandidateList& list : withoutNearPlaces(set, known, 2.0)) {
    EXPECT_LT(list.candidates.size(), set.learned.size());
    for (const Candidate& candidate : list.candidates) EXPECT_FALSE(candidate.right);
  }
}

TEST(AmongFewPlaces, KeepsOneRightPlaceAndAFewOthers) {
  CandidateList list;
  for (std::size_t i = 0; i < 20; ++i) {
    list.candidates.emplace_back();
    list.candidates.back().place = i;
    list.candidates.back().right = i > 16;
  }
  CandidateList stranger = list;
  for (Candidate& candidate : stranger.candidates) candidate.right = false;
  std::set<std::size_t> sizes;
  for (const CandidateList& few : amongFewPlaces(std::vector<CandidateList>(1000, list))) {
    sizes.insert(few.candidates.size());
    EXPECT_TRUE(few.candidates.front().right);
    for (std::size_t i = 1; i < few.candidates.size(); ++i) {
      EXPECT_FALSE(few.candidates[i].right);
    }
  }
  EXPECT_EQ(sizes, (std::set<std::size_t>{1, 2, 3, 4}));
  for (const CandidateList& few : amongFewPlaces({stranger, CandidateList{}})) {
    EXPECT_LE(few.candidates.size(), 4U);
  }
}

TEST(FitCalibration, TellsKnownScansFromStrangersBetterThanChance) {
  const core::SonarModel model{{}};
  const config::MatchPreset preset = config::loadPreset("evidence");
  const core::MatchMetric& metric = preset.metric;
  std::vector<CandidateList> known, strangers;
  for (const std::uint64_t seed : {2U, 3U, 4U}) {
    const trials::TrialSet set = trainingSet(seed);
    const auto lists = alignAll(set, model, metric);
    const auto without = withoutNearPlaces(set, lists, 2.0);
    known.insert(known.end(), lists.begin(), lists.end());
    strangers.insert(strangers.end(), without.begin(), without.end());
  }
  const RankingWeights weights{asWeights(metric), preset.rescoring};
  const core::Calibration calibration = fitCalibration({{known, strangers}}, weights);
  const CalibrationReport report = reportCalibration(known, strangers, weights, calibration, 0.6);
  EXPECT_GT(report.recognized, report.accepted);
  EXPECT_GT(report.refused, report.missed);
  EXPECT_LT(report.calibration_error, 0.25);
}

TEST(AlignSparse, StrangersAreThoseOfElsewhereAndThoseWithoutTheirPlaces) {
  const trials::SparseTrials made = trials::simulateSparse(trials::SparseKind::kHall, 2);
  const CalibrationScans scans = alignSparse(trials::SparseKind::kHall, 2, core::SonarModel{{}},
                                             config::loadPreset("evidence").metric);
  EXPECT_EQ(scans.known.size(), made.known.trials.size());
  EXPECT_EQ(scans.strangers.size(), made.known.trials.size() + made.strangers.size());
  for (const CandidateList& list : scans.strangers) {
    for (const Candidate& candidate : list.candidates) EXPECT_FALSE(candidate.right);
  }
}

TEST(FitCalibration, AScanWithoutAnOccupiedCellIsNeverRecognized) {
  CalibrationScans silent = alignSparse(trials::SparseKind::kHall, 2, core::SonarModel{{}},
                                        config::loadPreset("evidence").metric);
  for (CandidateList& list : silent.known) list.own[8] = 0.0;  // occupied on occupied
  core::Calibration sure;
  sure.right = {20.0};
  const RankingWeights weights{asWeights(config::loadPreset("evidence").metric), std::nullopt};
  const CalibrationReport report =
      reportCalibration(silent.known, silent.known, weights, sure, 0.8);
  EXPECT_EQ(report.recognized + report.wrong + report.accepted, 0.0);
  EXPECT_NEAR(report.missed, 1.0, 1e-9);
}

TEST(WritePreset, IsReadBackAsItWas) {
  config::MatchPreset preset;
  preset.metric.weights = {{{0.5, -1.25, 2.0}, {0.0, 0.125, -3.0}, {4.0, -5.5, 6.0}}};
  preset.metric.shift_cost = 1.5;
  preset.metric.rotation_cost = 2.5;
  preset.metric.overlap_only = true;
  core::RescoringWeights rescoring;
  rescoring.search_score = 0.75;
  rescoring.inner = {{{3.5, -2.25, 1.0}, {0.5, 0.25, -6.0}, {8.0, -0.5, 16.0}}};
  rescoring.middle = {{{1.5, -0.25, 2.0}, {4.5, 0.75, -3.0}, {5.0, -1.5, 32.0}}};
  rescoring.peak_sharpness_shift = -0.5;
  rescoring.peak_sharpness_rotation = 0.375;
  rescoring.near = {1.0, -2.0, 4.0, -8.0, 0.5, 0.25, -0.125};
  preset.rescoring = rescoring;
  preset.calibration.scale = 0.5;
  preset.calibration.right = {-1.0, 0.25, -0.5, -0.75, 2.0, 3.0, 4.0,  5.0, 1.25, 0.5, -8.0, 6.0,
                              7.0,  -7.0, 9.0,  0.75,  1.5, 3.5, -2.5, 4.5, 8.5,  6.5, 7.5};
  preset.calibration.known = {1.0, 0.5, -1.5, -2.75, 8.0,  2.0, 3.0,  6.0, 2.25, 1.5, -4.0, 0.0,
                              1.0, 7.0, -9.0, 0.25,  -1.5, 2.5, -3.5, 4.0, 5.5,  6.0, 7.0};
  preset.calibration.sharpness = 0.0625;
  const std::string path = testing::TempDir() + "preset.yaml";
  writePreset(path, "Written by a test.", preset);
  const config::MatchPreset read = config::loadPreset(path);
  EXPECT_EQ(read.metric.weights, preset.metric.weights);
  EXPECT_EQ(read.metric.shift_cost, 1.5);
  EXPECT_EQ(read.metric.rotation_cost, 2.5);
  EXPECT_TRUE(read.metric.overlap_only);
  ASSERT_TRUE(read.rescoring);
  EXPECT_EQ(read.rescoring->search_score, 0.75);
  EXPECT_EQ(read.rescoring->inner, rescoring.inner);
  EXPECT_EQ(read.rescoring->middle, rescoring.middle);
  EXPECT_EQ(read.rescoring->near, rescoring.near);
  EXPECT_EQ(read.rescoring->peak_sharpness_shift, -0.5);
  EXPECT_EQ(read.rescoring->peak_sharpness_rotation, 0.375);
  EXPECT_EQ(read.calibration.scale, 0.5);
  EXPECT_EQ(read.calibration.right, preset.calibration.right);
  EXPECT_EQ(read.calibration.known, preset.calibration.known);
  EXPECT_EQ(read.calibration.sharpness, 0.0625);
}

TEST(WritePreset, WithoutASecondLookThereIsNone) {
  const std::string path = testing::TempDir() + "no_rescoring.yaml";
  writePreset(path, "Written by a test.", {});
  EXPECT_FALSE(config::loadPreset(path).rescoring);
}

TEST(WritePreset, AnUnwritablePathIsAnError) {
  EXPECT_THROW(writePreset("/nowhere/preset.yaml", "", {}), std::runtime_error);
}

}  // namespace
}  // namespace place_memory::training
