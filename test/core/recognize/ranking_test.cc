#include "core/recognize/ranking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace place_memory::core {
namespace {

/// Places that score so, each a kilometre from the last, all with the robot a metre from them.
struct Aligned {
  explicit Aligned(const std::vector<double>& scores) {
    places.cell_size = 0.1;
    for (const double score : scores) places.places.push_back({score, {1.0, 0.0, 0.0}});
    places.counts = [this](std::size_t i) {
      counted.push_back(i);
      AlignmentCounts counts;
      counts.pairs[2][2] = static_cast<int>(i);
      counts.near.near[0] = i < near.size() ? near[i] : 0;
      return counts;
    };
    places.frames = [this](const std::vector<std::size_t>& numbers) {
      asked.push_back(numbers);
      std::vector<PlaceFrame> frames;
      for (const std::size_t i : numbers) {
        frames.push_back({{1000.0 * static_cast<double>(i), 0.0, 0.0}, 1});
      }
      return std::optional(frames);
    };
    places.own[2][2] = 100;
  }

  AlignedPlaces places;
  std::vector<int> near;  ///< occupied cells within one, by place
  std::vector<std::size_t> counted;
  std::vector<std::vector<std::size_t>> asked;
};

std::vector<std::size_t> orderOf(const Ranking& ranking) {
  std::vector<std::size_t> order;
  for (const RankedPlace& place : ranking.places) order.push_back(place.number);
  return order;
}

/// Re-scoring by nothing but cells within one, a point each.
RecognizerOptions rescoring() {
  RecognizerOptions options;
  options.rescoring.emplace();
  options.rescoring->search_score = 0.0;
  options.rescoring->near[0] = 1.0;
  return options;
}

TEST(RankPlaces, WithoutRescoringTheSearchsOrderStays) {
  Aligned aligned({9.0, 7.0, 4.0});
  const Ranking ranking = rankPlaces(aligned.places, {}).value();
  EXPECT_EQ(orderOf(ranking), (std::vector<std::size_t>{0, 1, 2}));
  for (const RankedPlace& place : ranking.places) {
    EXPECT_FALSE(place.rescoring_score);
    EXPECT_EQ(place.score, place.search_score);
  }
  EXPECT_EQ(ranking.cluster.margin, 2.0);
  EXPECT_EQ(aligned.counted, (std::vector<std::size_t>{0}));
}

TEST(RankPlaces, KeepsBothScoresOfWhatItRescores) {
  Aligned aligned({9.0, 7.0, 4.0});
  aligned.near = {20, 50, 30};
  const Ranking ranking = rankPlaces(aligned.places, rescoring()).value();
  EXPECT_EQ(orderOf(ranking), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(ranking.places[0].search_score, 7.0);
  EXPECT_EQ(ranking.places[0].rescoring_score, 50.0);
  EXPECT_EQ(ranking.places[0].score, 50.0);
  EXPECT_EQ(ranking.places[2].search_score, 9.0);
  EXPECT_EQ(ranking.cluster.margin, 20.0);
}

TEST(RankPlaces, PlacesBeyondTheForemostStayBehindThem) {
  std::vector<double> scores;
  for (int i = 0; i < 13; ++i) scores.push_back(100.0 - i);
  Aligned aligned(scores);
  aligned.near = {5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 999};
  const Ranking ranking = rankPlaces(aligned.places, rescoring()).value();
  EXPECT_EQ(orderOf(ranking), (std::vector<std::size_t>{9, 8, 7, 6, 5, 4, 3, 2, 1, 0, 10, 11, 12}));
  EXPECT_FALSE(ranking.places[10].rescoring_score);
  EXPECT_EQ(ranking.places[10].score, 4.0);  // the least, less their distance to the last one
  EXPECT_EQ(ranking.places[12].score, 2.0);
  EXPECT_EQ(aligned.counted.size(), 10U);
}

TEST(RankPlaces, OfEqualScoresTheSearchsOrderHolds) {
  Aligned aligned({9.0, 7.0, 4.0});
  aligned.near = {20, 30, 30};
  EXPECT_EQ(orderOf(rankPlaces(aligned.places, rescoring()).value()),
            (std::vector<std::size_t>{1, 2, 0}));
}

TEST(RankPlaces, TheNearestOfThoseThatAgreeComesFirstAndTheOthersKeepTheirOrder) {
  Aligned aligned({9.0, 8.0, 7.0});
  aligned.places.places[1].place_from_scan = {0.5, 0.0, 0.0};
  aligned.places.frames = [](const std::vector<std::size_t>& numbers) {
    std::vector<PlaceFrame> frames{
        {{0.0, 0.0, 0.0}, 1}, {{0.5, 0.0, 0.0}, 1}, {{7.0, 0.0, 0.0}, 1}};
    EXPECT_EQ(numbers.size(), frames.size());
    return std::optional(frames);
  };
  const Ranking ranking = rankPlaces(aligned.places, {}).value();
  EXPECT_EQ(orderOf(ranking), (std::vector<std::size_t>{1, 0, 2}));
  EXPECT_EQ(ranking.frame.map_from_place.x, 0.5);
  EXPECT_EQ(ranking.cluster.margin, 2.0);
  EXPECT_EQ(ranking.features[4], 0.01);  // occupied on occupied cells: those of the chosen place
}

TEST(RankPlaces, AsksOnceForTheFramesOfTheForemostInTheirNewOrder) {
  std::vector<double> scores(15, 1.0);
  Aligned aligned(scores);
  aligned.near = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  rankPlaces(aligned.places, rescoring()).value();
  ASSERT_EQ(aligned.asked.size(), 1U);
  EXPECT_EQ(aligned.asked.front(), (std::vector<std::size_t>{9, 8, 7, 6, 5, 4, 3, 2, 1, 0}));
}

TEST(RankPlaces, WhereOneIsGoneThereIsNoRanking) {
  Aligned aligned({9.0, 7.0});
  aligned.places.frames = [](const std::vector<std::size_t>&) {
    return std::optional<std::vector<PlaceFrame>>();
  };
  EXPECT_FALSE(rankPlaces(aligned.places, {}));
}

TEST(RankPlaces, WherePlacesLieDoesNotCountWhereItIsNotKnown) {
  Aligned aligned({9.0, 8.0});
  aligned.places.frames = [](const std::vector<std::size_t>& numbers) {
    return std::optional(std::vector<PlaceFrame>(numbers.size()));
  };
  RecognizerOptions options;
  EXPECT_EQ(rankPlaces(aligned.places, options)->cluster.unopposed, 9.0);
  options.located = false;
  EXPECT_EQ(rankPlaces(aligned.places, options)->cluster.margin, 1.0);
}

}  // namespace
}  // namespace place_memory::core
