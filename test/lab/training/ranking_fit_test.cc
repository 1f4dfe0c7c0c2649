#include "training/ranking_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "training/candidates.h"

namespace place_memory::training {
namespace {

/// Choices in which the candidate that scores best by `truth` plus noise is right.
std::vector<Choice> drawChoices(const Features& truth, unsigned seed, int count) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> feature(0.0, 1.0);
  std::extreme_value_distribution<double> noise(0.0, 1.0);
  std::vector<Choice> choices(static_cast<std::size_t>(count));
  for (Choice& choice : choices) {
    choice.features = Eigen::MatrixXd(8, kFeatures);
    choice.features = choice.features.unaryExpr([&](double) { return feature(engine); });
    choice.features.rightCols<2>() = choice.features.rightCols<2>().cwiseAbs();
    Eigen::VectorXd scores = choice.features * truth;
    for (double& score : scores) score += noise(engine);
    Eigen::Index best = 0;
    scores.maxCoeff(&best);
    choice.right.assign(8, false);
    choice.right[static_cast<std::size_t>(best)] = true;
  }
  return choices;
}

Features someTruth() {
  Features truth;
  truth << 1.0, -0.5, 0.3, 0.0, 0.2, -1.0, -0.8, 0.4, 2.0, -0.7, -0.3;
  return truth;
}

TEST(FitRanking, FindsTheWeightsThatTheListsWereDrawnFrom) {
  const Features truth = someTruth();
  const Features found = fitRanking(drawChoices(truth, 1, 4000), Features::Zero(), 1e-6, kCosts);
  EXPECT_LT((found - truth).cwiseAbs().maxCoeff(), 0.15);
}

TEST(BestScale, FindsTheScaleOfWeightsThatAreAThousandfoldTooLarge) {
  const Features truth = someTruth();
  const double scale = bestScale(drawChoices(truth, 5, 2000), 1024.0 * truth);
  EXPECT_NEAR(std::log2(scale), -10.0, 0.25);
}

TEST(FitRanking, IsNoWorseThanAnyNeighbour) {
  const std::vector<Choice> choices = drawChoices(someTruth(), 2, 300);
  const Features found = fitRanking(choices, Features::Zero(), 0.0, kCosts);
  const double loss = rankingLoss(choices, found);
  for (Eigen::Index i = 0; i < kFeatures - 2; ++i) {
    for (const double by : {-0.05, 0.05}) {
      Features other = found;
      other[i] += by;
      EXPECT_GE(rankingLoss(choices, other), loss - 1e-6) << i;
    }
  }
}

TEST(FitRanking, CostsOfTheTransformStayCosts) {
  Features truth = someTruth();
  truth.tail<2>() << 0.8, 0.9;
  const Features found = fitRanking(drawChoices(truth, 3, 1000), Features::Zero(), 1e-6, kCosts);
  EXPECT_LE(found[9], 0.0);
  EXPECT_LE(found[10], 0.0);
}

TEST(FitRanking, ChoicesWithoutARightCandidateDoNotCount) {
  std::vector<Choice> choices = drawChoices(someTruth(), 4, 50);
  const double loss = rankingLoss(choices, someTruth());
  const double share = topOne(choices, someTruth());
  choices.push_back(choices.front());
  choices.back().right.assign(8, false);
  EXPECT_DOUBLE_EQ(rankingLoss(choices, someTruth()), loss);
  EXPECT_DOUBLE_EQ(topOne(choices, someTruth()), share);
}

CandidateList someList() {
  CandidateList list;
  for (std::size_t i = 0; i < 15; ++i) {
    Candidate candidate;
    candidate.place = i;
    candidate.features[8] = static_cast<double>(i);
    candidate.near.inner[0][2] = static_cast<int>(i) + 100;
    candidate.near.middle[2][1] = static_cast<int>(i) + 300;
    candidate.near.near[6] = static_cast<int>(i) + 200;
    candidate.sharpness = {-1.0 * static_cast<double>(i), -0.5 * static_cast<double>(i)};
    candidate.at_truth = i == 12;
    list.candidates.push_back(candidate);
  }
  return list;
}

TEST(SecondChoices, AreAmongTheBestOfTheFirstLook) {
  Features weights = Features::Zero();
  weights[8] = 2.0;
  const Choice choice = rescoringChoices({someList()}, weights).front();
  ASSERT_EQ(choice.features.rows(), static_cast<Eigen::Index>(core::kRescored));
  EXPECT_EQ(choice.features(0, 0), 28.0);
  EXPECT_EQ(choice.features(2, 3), 112.0);
  EXPECT_EQ(choice.features(2, 17), 312.0);
  EXPECT_EQ(choice.features(2, 25), 212.0);
  EXPECT_EQ(choice.features(2, 26), -12.0);
  EXPECT_EQ(choice.features(2, 27), -6.0);
  EXPECT_TRUE(choice.right[2]);
  EXPECT_EQ(std::count(choice.right.begin(), choice.right.end(), true), 1);
}

TEST(SecondChoices, ScoreAsTheRecognizerScores) {
  Features weights = Features::Zero();
  weights[8] = 2.0;
  core::RescoringWeights rescoring;
  rescoring.search_score = 0.5;
  rescoring.inner[0][2] = 0.25;
  rescoring.middle[2][1] = -0.5;
  rescoring.near[6] = -0.125;
  rescoring.peak_sharpness_shift = 0.75;
  rescoring.peak_sharpness_rotation = -1.5;
  const CandidateList list = someList();
  const Choice choice = rescoringChoices({list}, weights).front();
  EXPECT_DOUBLE_EQ(
      (choice.features * asWeights(rescoring))[0],
      core::rescore(28.0, list.candidates[14].near, list.candidates[14].sharpness, rescoring));
}

TEST(AsSecondLook, IsTheInverseOfAsWeights) {
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(28, 0.5, 14.0);
  EXPECT_EQ(asWeights(asRescoringWeights(weights)), weights);
}

TEST(AsMetric, IsTheInverseOfAsWeights) {
  const Features truth = someTruth();
  EXPECT_EQ(asWeights(asMetric(truth)), truth);
}

}  // namespace
}  // namespace place_memory::training
