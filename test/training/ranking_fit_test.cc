#include "training/ranking_fit.h"

#include <gtest/gtest.h>

#include <random>

namespace place_memory::training {
namespace {

/// Lists in which the candidate that scores best by `truth` plus noise is right.
std::vector<CandidateList> drawLists(const Features& truth, unsigned seed, int count) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> feature(0.0, 1.0);
  std::extreme_value_distribution<double> noise(0.0, 1.0);
  std::vector<CandidateList> lists(static_cast<std::size_t>(count));
  for (CandidateList& list : lists) {
    std::size_t best = 0;
    double most = -1e9;
    for (std::size_t i = 0; i < 8; ++i) {
      Candidate candidate;
      candidate.place = i;
      for (double& f : candidate.features) f = feature(engine);
      candidate.features.tail<2>() = candidate.features.tail<2>().cwiseAbs();
      const double score = truth.dot(candidate.features) + noise(engine);
      if (score > most) {
        most = score;
        best = i;
      }
      list.candidates.push_back(candidate);
    }
    list.candidates[best].right = list.candidates[best].at_truth = true;
  }
  return lists;
}

Features someTruth() {
  Features truth;
  truth << 1.0, -0.5, 0.3, 0.0, 0.2, -1.0, -0.8, 0.4, 2.0, -0.7, -0.3;
  return truth;
}

TEST(FitRanking, FindsTheWeightsThatTheListsWereDrawnFrom) {
  const Features truth = someTruth();
  const Features found = fitRanking(drawLists(truth, 1, 4000), Features::Zero(), 1e-6);
  EXPECT_LT((found - truth).cwiseAbs().maxCoeff(), 0.15);
}

TEST(FitRanking, IsNoWorseThanAnyNeighbour) {
  const std::vector<CandidateList> lists = drawLists(someTruth(), 2, 300);
  const Features found = fitRanking(lists, Features::Zero(), 0.0);
  const double loss = rankingLoss(lists, found);
  for (Eigen::Index i = 0; i < kFeatures - 2; ++i) {
    for (const double by : {-0.05, 0.05}) {
      Features other = found;
      other[i] += by;
      EXPECT_GE(rankingLoss(lists, other), loss - 1e-6) << i;
    }
  }
}

TEST(FitRanking, CostsOfTheTransformStayCosts) {
  Features truth = someTruth();
  truth.tail<2>() << 0.8, 0.9;
  const Features found = fitRanking(drawLists(truth, 3, 1000), Features::Zero(), 1e-6);
  EXPECT_LE(found[9], 0.0);
  EXPECT_LE(found[10], 0.0);
}

TEST(FitRanking, ListsWithoutARightPlaceDoNotCount) {
  std::vector<CandidateList> lists = drawLists(someTruth(), 4, 50);
  const double loss = rankingLoss(lists, someTruth());
  const double share = topOne(lists, someTruth());
  lists.push_back(lists.front());
  for (Candidate& candidate : lists.back().candidates) candidate.right = candidate.at_truth = false;
  EXPECT_DOUBLE_EQ(rankingLoss(lists, someTruth()), loss);
  EXPECT_DOUBLE_EQ(topOne(lists, someTruth()), share);
}

TEST(AsMetric, IsTheInverseOfAsWeights) {
  const Features truth = someTruth();
  EXPECT_EQ(asWeights(asMetric(truth)), truth);
}

}  // namespace
}  // namespace place_memory::training
