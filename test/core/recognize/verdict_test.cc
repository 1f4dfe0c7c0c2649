#include "core/recognize/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace place_memory::core {
namespace {

Recognition withScores(const std::vector<double>& scores) {
  Recognition recognition;
  PlaceId id = 1;
  for (const double score : scores) recognition.matches.push_back({id++, score, {}, 0.0});
  return recognition;
}

std::size_t named(const std::string& name) {
  std::size_t i = 0;
  while (name != kCalibrationFeatureNames.at(i)) ++i;
  return i;
}

/// How well the scan and its best match agree, with this margin.
CalibrationFeatures features(double agreement, double margin) {
  CalibrationFeatures features{};
  features[named("bias")] = 1.0;
  features[named("empty_on_empty")] = features[named("occupied_on_occupied")] = agreement;
  features[named("occupied_on_empty")] = 1.0 - agreement;
  features[named("margin")] = std::log1p(margin);
  return features;
}

Recognition judged(const std::vector<double>& scores, const CalibrationFeatures& features,
                   const Calibration& calibration = {}) {
  Recognition recognition = withScores(scores);
  judge(features, calibration, 0.8, recognition);
  return recognition;
}

const PairCounts kOwn{{{100, 0, 0}, {0, 50, 0}, {0, 0, 20}}};
const PairCounts kAt{{{60, 30, 10}, {7, 8, 9}, {4, 1, 15}}};

TEST(CalibrationFeaturesOf, SharesAreThoseOfTheScansCells) {
  RescoringCounts near;
  near.near = {16, 18, 0, 0, 0, 25, 0};
  const CalibrationFeatures found =
      calibrationFeatures({kAt, near, {-6.0, -4.0}}, kOwn, {0, 3.0, 5.0, 7.0}, 4, 0.5);
  EXPECT_EQ(found[named("bias")], 1.0);
  EXPECT_EQ(found[named("empty_on_empty")], 0.6);
  EXPECT_EQ(found[named("empty_on_occupied")], 0.1);
  EXPECT_EQ(found[named("occupied_on_empty")], 0.2);
  EXPECT_EQ(found[named("occupied_on_occupied")], 0.75);
  EXPECT_EQ(found[named("occupied_within_one")], 0.8);
  EXPECT_EQ(found[named("occupied_within_two")], 0.9);
  EXPECT_EQ(found[named("empty_by_occupied")], 0.25);
  EXPECT_DOUBLE_EQ(found[named("learned_occupied_on_empty")], 10.0 / 34.0);
  EXPECT_DOUBLE_EQ(found[named("learned_occupied_on_occupied")], 15.0 / 34.0);
  EXPECT_DOUBLE_EQ(found[named("learned_empty_on_occupied")], 4.0 / 71.0);
  EXPECT_DOUBLE_EQ(found[named("margin")], std::log1p(1.5));
  EXPECT_EQ(found[named("mean_margin")], 2.5);
  EXPECT_EQ(found[named("unopposed")], 3.5);
  EXPECT_EQ(found[named("inverse_place_count")], 0.25);
  EXPECT_DOUBLE_EQ(found[named("occupied_cells")], std::log(21.0));
  EXPECT_DOUBLE_EQ(found[named("learned_occupied_cells")], std::log(35.0));
  EXPECT_DOUBLE_EQ(found[named("cells_within_one")], std::log(17.0));
  EXPECT_DOUBLE_EQ(found[named("cells_within_one_squared")], std::pow(std::log(17.0), 2));
  EXPECT_DOUBLE_EQ(found[named("occupied_per_empty")], std::log(21.0 / 101.0));
  EXPECT_DOUBLE_EQ(found[named("learned_occupied_per_empty")], std::log(35.0 / 72.0));
  EXPECT_DOUBLE_EQ(found[named("fall_by_shift")], std::log(4.0));
  EXPECT_DOUBLE_EQ(found[named("fall_by_rotation")], std::log(3.0));
}

TEST(CalibrationFeaturesOf, SharesAreNothingWhereTheScanHasNoSuchCell) {
  const PairCounts unsensed{{{0, 0, 0}, {0, 4096, 0}, {0, 0, 0}}};
  const CalibrationFeatures found = calibrationFeatures({unsensed, {}, {}}, unsensed, {}, 2, 1.0);
  for (const char* name : {"empty_on_empty", "occupied_on_occupied", "empty_by_occupied",
                           "learned_occupied_on_occupied", "learned_empty_on_occupied"}) {
    EXPECT_EQ(found[named(name)], 0.0) << name;
  }
}

TEST(Judge, WithoutPlacesIsUnknown) {
  EXPECT_EQ(judged({}, features(0.9, 0.0)).verdict, Verdict::kUnknown);
}

TEST(Judge, AGoodMatchFarAheadIsRecognized) {
  EXPECT_EQ(judged({40.0, 5.0}, features(0.9, 35.0)).verdict, Verdict::kRecognized);
}

TEST(Judge, AGoodMatchWithACloseRunnerUpIsAmbiguous) {
  EXPECT_EQ(judged({40.0, 39.9}, features(0.9, 0.1)).verdict, Verdict::kAmbiguous);
}

TEST(Judge, TheOnlyPlaceIsNeverAmbiguous) {
  EXPECT_EQ(judged({20.0}, features(0.9, 0.0)).verdict, Verdict::kUnknown);
}

TEST(Judge, ABadMatchIsUnknownHoweverFarAhead) {
  EXPECT_EQ(judged({40.0, 5.0}, features(0.3, 35.0)).verdict, Verdict::kUnknown);
}

TEST(Judge, ProbabilitiesSumToAtMostOneAndTheOthersFallWithTheirScores) {
  const Recognition recognition = judged({12.0, 11.0, 10.5, 3.0, -40.0}, features(0.9, 1.0));
  double all = 0.0;
  for (std::size_t i = 0; i < recognition.matches.size(); ++i) {
    const double p = recognition.matches[i].probability;
    EXPECT_GE(p, 0.0);
    EXPECT_LE(p, i == 0 ? 1.0 : recognition.matches[i - 1].probability);
    all += p;
  }
  EXPECT_LE(all, 1.0 + 1e-12);
}

TEST(Judge, AChosenMatchMayScoreLessThanTheOthers) {
  const Recognition recognition = judged({9.0, 900.0, 2000.0}, features(0.9, 2.0));
  EXPECT_TRUE(std::isfinite(recognition.matches[1].probability));
  EXPECT_GT(recognition.matches[2].probability, recognition.matches[1].probability);
}

TEST(Judge, TheOddsFollowTheStatedFormula) {
  Calibration calibration;
  calibration.scale = 0.5;
  double right = 0.0, known = 0.0;
  const CalibrationFeatures given = features(0.9, 4.0);
  for (std::size_t i = 0; i < given.size(); ++i) {
    calibration.right[i] = 0.1 * static_cast<double>(i) - 0.2;
    calibration.known[i] = 0.2 * static_cast<double>(i) - 0.5;
    right += calibration.right[i] * given[i];
    known += calibration.known[i] * given[i];
  }
  const Recognition recognition = judged({9.0, 5.0}, given, calibration);
  const double p = 1.0 / (1.0 + std::exp(-right));
  EXPECT_NEAR(recognition.matches[0].probability, p, 1e-12);
  EXPECT_NEAR(recognition.matches[1].probability, 1.0 / (1.0 + std::exp(-known)) - p, 1e-12);
}

TEST(Judge, NoOtherMatchIsMoreLikelyThanTheBest) {
  Calibration calibration;
  calibration.right = {-2.0};
  calibration.known = {4.0};
  const Recognition recognition = judged({9.0, 8.9, 3.0}, features(0.5, 0.1), calibration);
  EXPECT_EQ(recognition.verdict, Verdict::kAmbiguous);
  EXPECT_EQ(recognition.matches[1].probability, recognition.matches[0].probability);
  EXPECT_LT(recognition.matches[2].probability, recognition.matches[1].probability);
}

TEST(Judge, SomePlaceIsNeverLessLikelyThanTheBest) {
  Calibration calibration;
  calibration.right = {0.5};
  calibration.known = {-4.0};
  EXPECT_EQ(judged({9.0, 8.0}, features(0.5, 0.1), calibration).matches[1].probability, 0.0);
}

}  // namespace
}  // namespace place_memory::core
