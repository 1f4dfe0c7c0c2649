#include "core/recognize/hypothesis_cluster.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace place_memory::core
