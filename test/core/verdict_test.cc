#include "place_memory/core/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::core {
namespace {

Recognition withScores(const std::vector<double>& scores) {
  Recognition recognition;
  PlaceId id = 1;
  for (const double score : scores) recognition.matches.push_back({id++, score, {}, 0.0});
  return recognition;
}

const Agreement kGood{{{0.9, 0.0}, {0.0, 0.9}}};
const Agreement kBad{{{0.3, 0.1}, {0.5, 0.1}}};

Recognition judged(const std::vector<double>& scores, const Agreement& agreement,
                   const Calibration& calibration = {}) {
  Recognition recognition = withScores(scores);
  const double runner_up = scores.size() > 1 ? scores[1] : 0.0;
  judge(agreement, scores.front() - runner_up, calibration, 0.8, recognition);
  return recognition;
}

TEST(AgreementOf, IsTheShareOfTheScansCells) {
  const PairCounts own{{{100, 0, 0}, {0, 50, 0}, {0, 0, 20}}};
  const PairCounts at{{{60, 30, 10}, {7, 8, 9}, {4, 1, 15}}};
  const Agreement expected{{{0.6, 0.1}, {0.2, 0.75}}};
  EXPECT_EQ(agreementOf(at, own), expected);
}

TEST(AgreementOf, IsNothingWhereTheScanHasNoSuchCell) {
  const PairCounts own{{{0, 0, 0}, {0, 4096, 0}, {0, 0, 0}}};
  EXPECT_EQ(agreementOf(own, own), Agreement{});
}

TEST(Judge, WithoutPlacesIsUnknown) {
  Recognition recognition;
  judge(kGood, 0.0, {}, 0.8, recognition);
  EXPECT_EQ(recognition.verdict, Verdict::kUnknown);
}

TEST(Judge, AGoodMatchFarAheadIsRecognized) {
  EXPECT_EQ(judged({40.0, 5.0}, kGood).verdict, Verdict::kRecognized);
}

TEST(Judge, AGoodMatchWithACloseRunnerUpIsAmbiguous) {
  EXPECT_EQ(judged({40.0, 39.9}, kGood).verdict, Verdict::kAmbiguous);
}

TEST(Judge, ABadMatchIsUnknownHoweverFarAhead) {
  EXPECT_EQ(judged({40.0, 5.0}, kBad).verdict, Verdict::kUnknown);
}

TEST(Judge, ALonePlaceCompetesWithNothing) {
  EXPECT_EQ(judged({40.0}, kGood).verdict, Verdict::kRecognized);
}

TEST(Judge, ProbabilitiesFallWithTheScoresAndSumToAtMostOne) {
  const Recognition recognition = judged({12.0, 11.0, 10.5, 3.0, -40.0}, kGood);
  double all = 0.0;
  for (std::size_t i = 0; i < recognition.matches.size(); ++i) {
    const double p = recognition.matches[i].probability;
    EXPECT_GE(p, 0.0);
    EXPECT_LE(p, i == 0 ? 1.0 : recognition.matches[i - 1].probability);
    all += p;
  }
  EXPECT_LE(all, 1.0 + 1e-12);
}

TEST(Judge, TheOddsFollowTheStatedFormula) {
  const Calibration calibration{0.5, -1.0, {{{0.3, -0.2}, {-0.4, 0.7}}}, 0.6, 0.25, 0.1};
  const Recognition recognition = judged({9.0, 5.0}, kGood, calibration);
  const double log_odds = -1.0 + 0.3 * 0.9 + 0.7 * 0.9 + 0.6 * std::log1p(0.5 * 4.0);
  const double p = 1.0 / (1.0 + std::exp(-log_odds));
  EXPECT_NEAR(recognition.matches[0].probability, p, 1e-12);
  EXPECT_NEAR(recognition.matches[1].probability, 0.25 * (1.0 - p), 1e-12);
}

}  // namespace
}  // namespace place_memory::core
