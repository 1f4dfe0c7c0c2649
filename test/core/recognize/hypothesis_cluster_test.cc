#include "core/recognize/hypothesis_cluster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace place_memory::core {
namespace {

constexpr double kCell = 0.14;

TEST(ClusterHypotheses, ALonePlaceIsChosenAndNothingContradictsIt) {
  const HypothesisCluster cluster = clusterHypotheses({{7.0, 0.3, Pose2d{1.0, 2.0, 0.0}}}, kCell);
  EXPECT_EQ(cluster.chosen, 0U);
  EXPECT_EQ(cluster.margin, 0.0);
  EXPECT_EQ(cluster.mean_margin, 0.0);
  EXPECT_EQ(cluster.unopposed, 7.0);
}

TEST(ClusterHypotheses, OfThoseThatAgreeTheNearestPlaceIsChosen) {
  const HypothesisCluster cluster = clusterHypotheses({{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}},
                                                       {8.0, 0.2, Pose2d{1.1, 2.1, 0.1}},
                                                       {7.0, 0.4, Pose2d{0.9, 2.0, 0.0}}},
                                                      kCell);
  EXPECT_EQ(cluster.chosen, 1U);
}

TEST(ClusterHypotheses, APlaceThatPutsTheRobotElsewhereIsNotChosenAndCounts) {
  const HypothesisCluster cluster = clusterHypotheses(
      {{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}}, {8.0, 0.0, Pose2d{5.0, 2.0, 0.0}}}, kCell);
  EXPECT_EQ(cluster.chosen, 0U);
  EXPECT_EQ(cluster.margin, 1.0);
}

TEST(ClusterHypotheses, AnotherHeadingAtTheSameSpotContradicts) {
  const HypothesisCluster cluster = clusterHypotheses(
      {{9.0, 0.1, Pose2d{1.0, 2.0, 0.0}}, {8.0, 0.0, Pose2d{1.0, 2.0, kPi}}}, kCell);
  EXPECT_EQ(cluster.chosen, 0U);
  EXPECT_EQ(cluster.margin, 1.0);
}

TEST(ClusterHypotheses, HeadingsAgreeAcrossTheHalfTurn) {
  const HypothesisCluster cluster = clusterHypotheses(
      {{9.0, 0.5, Pose2d{1.0, 2.0, kPi - 0.05}}, {8.0, 0.1, Pose2d{1.0, 2.0, -kPi + 0.05}}}, kCell);
  EXPECT_EQ(cluster.chosen, 1U);
}

TEST(ClusterHypotheses, PlacesOfWhichNoneKnowsWhereTheyLieContradictEachOther) {
  const HypothesisCluster cluster =
      clusterHypotheses({{9.0, 0.9, std::nullopt}, {8.0, 0.0, std::nullopt}}, kCell);
  EXPECT_EQ(cluster.chosen, 0U);
  EXPECT_EQ(cluster.margin, 1.0);
}

TEST(ClusterHypotheses, TheMarginIsOverTheBestThatContradictsAndTheMeanMarginOverTheirMean) {
  const HypothesisCluster cluster = clusterHypotheses({{9.0, 0.1, Pose2d{1.0, 2.0, 0.0}},
                                                       {8.5, 0.3, Pose2d{1.1, 2.0, 0.0}},
                                                       {7.0, 0.0, Pose2d{9.0, 2.0, 0.0}},
                                                       {3.0, 0.0, Pose2d{1.0, 9.0, 0.0}}},
                                                      kCell);
  EXPECT_EQ(cluster.margin, 2.0);
  EXPECT_EQ(cluster.mean_margin, 4.0);
  EXPECT_EQ(cluster.unopposed, 0.0);
}

TEST(ClusterHypotheses, WhereAllAgreeThereIsNoMargin) {
  const HypothesisCluster cluster = clusterHypotheses(
      {{9.0, 0.1, Pose2d{1.0, 2.0, 0.0}}, {8.5, 0.3, Pose2d{1.1, 2.0, 0.0}}}, kCell);
  EXPECT_EQ(cluster.margin, 0.0);
  EXPECT_EQ(cluster.mean_margin, 0.0);
}

TEST(ClusterHypotheses, PlacesOfAnotherSessionNeitherAgreeNorContradict) {
  const HypothesisCluster cluster = clusterHypotheses({{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}, 1},
                                                       {8.5, 0.1, Pose2d{1.0, 2.0, 0.0}, 2},
                                                       {8.0, 0.1, Pose2d{9.0, 2.0, 0.0}, 2},
                                                       {6.0, 0.3, Pose2d{9.0, 2.0, 0.0}, 1}},
                                                      kCell);
  EXPECT_EQ(cluster.chosen, 0U);
  EXPECT_EQ(cluster.margin, 3.0);
  EXPECT_EQ(cluster.mean_margin, 3.0);
}

TEST(ClusterHypotheses, AmongPlacesOfOtherSessionsTheBestIsNotContradicted) {
  const HypothesisCluster cluster = clusterHypotheses(
      {{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}, 2}, {8.5, 0.1, Pose2d{5.0, 2.0, 0.0}, 1}}, kCell);
  EXPECT_EQ(cluster.chosen, 0U);
  EXPECT_EQ(cluster.margin, 0.0);
  EXPECT_EQ(cluster.unopposed, 9.0);
}

/// What the best scores above one that puts the robot so far away; 0 where that agrees with it.
double marginTo(const Pose2d& other) {
  return clusterHypotheses({{9.0, 0.1, Pose2d{}}, {8.0, 0.2, other}}, kCell).margin;
}

TEST(ClusterHypotheses, ThreeAndAHalfCellsAreOneSpot) {
  for (const double way : {0.0, 0.4, 1.9, kPi}) {
    const double x = std::cos(way), y = std::sin(way);
    EXPECT_EQ(marginTo({3.499 * kCell * x, 3.499 * kCell * y, 0.0}), 0.0) << way;
    EXPECT_EQ(marginTo({3.501 * kCell * x, 3.501 * kCell * y, 0.0}), 1.0) << way;
  }
  EXPECT_EQ(marginTo({3.5 * kCell, 0.0, 0.0}), 0.0);
}

TEST(ClusterHypotheses, CellsAreOfTheGridsSize) {
  const std::vector<PoseHypothesis> apart{{9.0, 0.1, Pose2d{}}, {8.0, 0.2, Pose2d{1.0, 0.0, 0.0}}};
  EXPECT_EQ(clusterHypotheses(apart, 1.001 / 3.5).margin, 0.0);
  EXPECT_EQ(clusterHypotheses(apart, 0.999 / 3.5).margin, 1.0);
}

TEST(ClusterHypotheses, TwentyFiveDegreesAreOneHeading) {
  constexpr double kDegree = kPi / 180.0;
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(marginTo({0.0, 0.0, sign * 24.99 * kDegree}), 0.0);
    EXPECT_EQ(marginTo({0.0, 0.0, sign * 25.01 * kDegree}), 1.0);
  }
  EXPECT_EQ(marginTo({0.0, 0.0, 25.0 * kPi / 180.0}), 0.0);
}

/// The best one, then so many elsewhere that score 5, then one that scores 1 elsewhere too.
std::vector<PoseHypothesis> afterOthers(std::size_t others) {
  std::vector<PoseHypothesis> hypotheses{{9.0, 0.5, Pose2d{}}};
  for (std::size_t i = 0; i < others; ++i) hypotheses.push_back({5.0, 0.5, Pose2d{50.0, 0.0, 0.0}});
  hypotheses.push_back({1.0, 0.5, Pose2d{80.0, 0.0, 0.0}});
  return hypotheses;
}

TEST(ClusterHypotheses, TheBestTenCount) {
  EXPECT_DOUBLE_EQ(clusterHypotheses(afterOthers(8), kCell).mean_margin, 9.0 - 41.0 / 9.0);
  EXPECT_DOUBLE_EQ(clusterHypotheses(afterOthers(9), kCell).mean_margin, 4.0);
}

TEST(ClusterHypotheses, TheTenthIsChosenWhereItIsNearestAndTheEleventhIsNot) {
  for (const std::size_t others : {8U, 9U}) {
    std::vector<PoseHypothesis> hypotheses = afterOthers(others);
    hypotheses.back() = {1.0, 0.1, Pose2d{}};
    EXPECT_EQ(clusterHypotheses(hypotheses, kCell).chosen, others == 8 ? 9U : 0U);
  }
}

TEST(ClusterHypotheses, OfThoseEquallyNearTheBetterIsChosen) {
  const std::vector<PoseHypothesis> hypotheses{
      {9.0, 0.5, Pose2d{}}, {8.0, 0.2, Pose2d{}}, {7.0, 0.2, Pose2d{}}};
  EXPECT_EQ(clusterHypotheses(hypotheses, kCell).chosen, 1U);
}

TEST(ClusterHypotheses, AScoreBelowNothingThatNothingContradictsIsNone) {
  EXPECT_EQ(clusterHypotheses({{-2.0, 0.5, Pose2d{}}}, kCell).unopposed, 0.0);
}

}  // namespace
}  // namespace place_memory::core
