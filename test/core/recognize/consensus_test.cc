#include "core/recognize/consensus.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

constexpr double kCell = 0.14;

TEST(FindConsensus, ALonePlaceIsChosenAndNothingContradictsIt) {
  const Consensus consensus = findConsensus({{7.0, 0.3, Pose2d{1.0, 2.0, 0.0}}}, kCell);
  EXPECT_EQ(consensus.chosen, 0U);
  EXPECT_EQ(consensus.lead, 0.0);
  EXPECT_EQ(consensus.prominence, 0.0);
  EXPECT_EQ(consensus.uncontested, 7.0);
}

TEST(FindConsensus, OfThoseThatAgreeTheNearestPlaceIsChosen) {
  const Consensus consensus = findConsensus({{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}},
                                             {8.0, 0.2, Pose2d{1.1, 2.1, 0.1}},
                                             {7.0, 0.4, Pose2d{0.9, 2.0, 0.0}}},
                                            kCell);
  EXPECT_EQ(consensus.chosen, 1U);
}

TEST(FindConsensus, APlaceThatPutsTheRobotElsewhereIsNotChosenAndCounts) {
  const Consensus consensus =
      findConsensus({{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}}, {8.0, 0.0, Pose2d{5.0, 2.0, 0.0}}}, kCell);
  EXPECT_EQ(consensus.chosen, 0U);
  EXPECT_EQ(consensus.lead, 1.0);
}

TEST(FindConsensus, AnotherHeadingAtTheSameSpotContradicts) {
  const Consensus consensus =
      findConsensus({{9.0, 0.1, Pose2d{1.0, 2.0, 0.0}}, {8.0, 0.0, Pose2d{1.0, 2.0, kPi}}}, kCell);
  EXPECT_EQ(consensus.chosen, 0U);
  EXPECT_EQ(consensus.lead, 1.0);
}

TEST(FindConsensus, HeadingsAgreeAcrossTheHalfTurn) {
  const Consensus consensus = findConsensus(
      {{9.0, 0.5, Pose2d{1.0, 2.0, kPi - 0.05}}, {8.0, 0.1, Pose2d{1.0, 2.0, -kPi + 0.05}}}, kCell);
  EXPECT_EQ(consensus.chosen, 1U);
}

TEST(FindConsensus, PlacesOfWhichNoneKnowsWhereTheyLieContradictEachOther) {
  const Consensus consensus =
      findConsensus({{9.0, 0.9, std::nullopt}, {8.0, 0.0, std::nullopt}}, kCell);
  EXPECT_EQ(consensus.chosen, 0U);
  EXPECT_EQ(consensus.lead, 1.0);
}

TEST(FindConsensus, TheLeadIsOverTheBestThatContradictsAndTheProminenceOverTheirMean) {
  const Consensus consensus = findConsensus({{9.0, 0.1, Pose2d{1.0, 2.0, 0.0}},
                                             {8.5, 0.3, Pose2d{1.1, 2.0, 0.0}},
                                             {7.0, 0.0, Pose2d{9.0, 2.0, 0.0}},
                                             {3.0, 0.0, Pose2d{1.0, 9.0, 0.0}}},
                                            kCell);
  EXPECT_EQ(consensus.lead, 2.0);
  EXPECT_EQ(consensus.prominence, 4.0);
  EXPECT_EQ(consensus.uncontested, 0.0);
}

TEST(FindConsensus, WhereAllAgreeNoneIsLed) {
  const Consensus consensus =
      findConsensus({{9.0, 0.1, Pose2d{1.0, 2.0, 0.0}}, {8.5, 0.3, Pose2d{1.1, 2.0, 0.0}}}, kCell);
  EXPECT_EQ(consensus.lead, 0.0);
  EXPECT_EQ(consensus.prominence, 0.0);
}

TEST(FindConsensus, PlacesOfAnotherSessionNeitherAgreeNorContradict) {
  const Consensus consensus = findConsensus({{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}, 1},
                                             {8.5, 0.1, Pose2d{1.0, 2.0, 0.0}, 2},
                                             {8.0, 0.1, Pose2d{9.0, 2.0, 0.0}, 2},
                                             {6.0, 0.3, Pose2d{9.0, 2.0, 0.0}, 1}},
                                            kCell);
  EXPECT_EQ(consensus.chosen, 0U);
  EXPECT_EQ(consensus.lead, 3.0);
  EXPECT_EQ(consensus.prominence, 3.0);
}

TEST(FindConsensus, AmongPlacesOfOtherSessionsTheBestIsNotContradicted) {
  const Consensus consensus = findConsensus(
      {{9.0, 0.9, Pose2d{1.0, 2.0, 0.0}, 2}, {8.5, 0.1, Pose2d{5.0, 2.0, 0.0}, 1}}, kCell);
  EXPECT_EQ(consensus.chosen, 0U);
  EXPECT_EQ(consensus.lead, 0.0);
  EXPECT_EQ(consensus.uncontested, 9.0);
}

}  // namespace
}  // namespace place_memory::core
