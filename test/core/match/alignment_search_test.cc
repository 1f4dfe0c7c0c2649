#include "core/match/alignment_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/random_room.h"

namespace place_memory::core {
namespace {

constexpr double kStep = 3.0 * kPi / 180.0;
constexpr int kHalfCircle = 60;
constexpr SearchMethod kMethods[] = {SearchMethod::kNearestNeighbour, SearchMethod::kHillClimbing,
                                     SearchMethod::kRestarts, SearchMethod::kExhaustive};

/// An occupied cell on an occupied one tells more than empty space on empty space.
constexpr PairWeights kWeights{{{1.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, {-2.0, -1.0, 3.0}}};

struct Trial {
  Pose2d truth;  ///< pose of the recognition grid in the learned one
  CellPlanes learned;
  EvidenceGrid recognition;
};

/// A room sensed from its middle, and again from a random pose up to `metres` and `radians` off.
Trial randomTrial(unsigned seed, double metres, double radians) {
  std::mt19937 engine(seed * 7919);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const Pose2d truth{metres * share(engine), metres * share(engine), radians * share(engine)};
  const RandomRoom room(seed);
  return {truth, CellPlanes(room.scanFrom({}).grid), room.scanFrom(truth).grid};
}

Alignment align(const Trial& trial, const SearchWindow& window, SearchMethod method,
                const PairWeights& weights = kWeights) {
  const QueryPlanes query(trial.recognition, kStep, window.rotations);
  return findAlignment(query, trial.learned, {weights, 0.0, 0.0}, window, method);
}

double scoreAt(const QueryPlanes& query, const CellPlanes& learned, CellShift shift, int rotation) {
  return pairScore(countPairs(query.at(rotation), shift, learned), kWeights);
}

TEST(FindAlignment, OverlapAloneCountsWhereItIsAskedFor) {
  const Trial trial = randomTrial(5, 0.4, 0.2);
  const SearchWindow window{9, 15, false};
  const QueryPlanes query(trial.recognition, kStep, window.rotations);
  LatticeMetric metric{kPaperWeights, 0.0, 0.0, true};
  for (const SearchMethod method : kMethods) {
    const Alignment found = findAlignment(query, trial.learned, metric, window, method);
    EXPECT_DOUBLE_EQ(found.score,
                     pairScore(countOverlap(query.at(found.rotation), query.reach(found.rotation),
                                            found.shift, trial.learned),
                               kPaperWeights));
  }
}

/// Within a cell and a step of the truth, which itself lies between the cells and steps.
bool isRecovered(const Trial& trial, const Alignment& found) {
  const double off = wrapAngle(found.rotation * kStep - trial.truth.yaw);
  return std::abs(found.shift.columns - trial.truth.x / kDefaultCellSize) <= 1.5 &&
         std::abs(found.shift.rows - trial.truth.y / kDefaultCellSize) <= 1.5 &&
         std::abs(off) <= 1.5 * kStep;
}

int countRecovered(int trials, double metres, double radians, const SearchWindow& window,
                   SearchMethod method) {
  int recovered = 0;
  for (int i = 0; i < trials; ++i) {
    const Trial trial = randomTrial(static_cast<unsigned>(i + 1), metres, radians);
    if (isRecovered(trial, align(trial, window, method))) ++recovered;
  }
  return recovered;
}

TEST(AlignmentSearch, ExhaustiveRecoversRandomTransforms) {
  EXPECT_EQ(countRecovered(20, 0.8, 0.3, {7, 8, false}, SearchMethod::kExhaustive), 20);
}

TEST(AlignmentSearch, RestartsRecoverRandomTransforms) {
  EXPECT_EQ(countRecovered(20, 0.8, 0.3, {7, 8, false}, SearchMethod::kRestarts), 20);
}

TEST(AlignmentSearch, OneClimbRecoversMostSmallTransforms) {
  EXPECT_GE(countRecovered(20, 0.4, 0.1, {7, 8, false}, SearchMethod::kHillClimbing), 18);
}

TEST(AlignmentSearch, EveryMethodFindsTheGridOnItself) {
  for (const SearchMethod method : kMethods) {
    const Trial trial = randomTrial(3, 0.0, 0.0);
    const Alignment found = align(trial, {5, 4, false}, method);
    EXPECT_EQ(found.shift.columns, 0);
    EXPECT_EQ(found.shift.rows, 0);
    EXPECT_EQ(found.rotation, 0);
  }
}

TEST(AlignmentSearch, NearestNeighbourStaysWhereItIs) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Trial trial = randomTrial(seed, 0.8, 0.3);
    const SearchWindow window{7, 8, false};
    const Alignment found = align(trial, window, SearchMethod::kNearestNeighbour);
    EXPECT_EQ(found.shift.columns, 0);
    EXPECT_EQ(found.shift.rows, 0);
    EXPECT_EQ(found.rotation, 0);
    const QueryPlanes query(trial.recognition, kStep, 0);
    EXPECT_DOUBLE_EQ(found.score, scoreAt(query, trial.learned, {0, 0}, 0));
  }
}

TEST(AlignmentSearch, ACircularWindowFindsAnyHeading) {
  const SearchWindow window{4, kHalfCircle, true};
  for (const SearchMethod method : {SearchMethod::kRestarts, SearchMethod::kExhaustive}) {
    EXPECT_EQ(countRecovered(8, 0.3, kPi, window, method), 8);
  }
}

TEST(AlignmentSearch, ACircularWindowFindsTheHeadingsWhereItCloses) {
  const RandomRoom room(4);
  const CellPlanes learned(room.scanFrom({}).grid);
  for (const double yaw : {-kPi, -kPi + kStep, kPi - kStep, kPi - 0.4 * kStep}) {
    const Trial trial{{0.0, 0.0, yaw}, learned, room.scanFrom({0.0, 0.0, yaw}).grid};
    for (const SearchMethod method : {SearchMethod::kRestarts, SearchMethod::kExhaustive}) {
      EXPECT_TRUE(isRecovered(trial, align(trial, {2, kHalfCircle, true}, method))) << yaw;
    }
  }
}

TEST(AlignmentSearch, StaysInsideTheWindowAndTellsTheScoreOfWhatItFound) {
  // The truth lies outside most of these windows, so that every search presses against the edge.
  const SearchWindow windows[] = {{0, 0, false}, {1, 0, false}, {0, 1, false},
                                  {3, 2, false}, {6, 7, false}, {2, kHalfCircle, true}};
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Trial trial = randomTrial(seed, 1.5, 0.6);
    const QueryPlanes every(trial.recognition, kStep, kHalfCircle);
    for (const SearchWindow& window : windows) {
      const QueryPlanes query(trial.recognition, kStep, window.rotations);
      for (const SearchMethod method : kMethods) {
        const Alignment found =
            findAlignment(query, trial.learned, {kWeights, 0.0, 0.0}, window, method);
        EXPECT_LE(std::abs(found.shift.columns), window.cells);
        EXPECT_LE(std::abs(found.shift.rows), window.cells);
        ASSERT_LE(std::abs(found.rotation), window.rotations);
        EXPECT_DOUBLE_EQ(found.score, scoreAt(every, trial.learned, found.shift, found.rotation));
      }
    }
  }
}

TEST(AlignmentSearch, AWindowAsWideAsTheGridHoldsAllShiftsOfIt) {
  const Trial trial = randomTrial(2, 0.5, 0.0);
  const SearchWindow window{kGridSize - 1, 1, false};
  const Alignment climbed = align(trial, window, SearchMethod::kHillClimbing);
  const Alignment best = align(trial, window, SearchMethod::kExhaustive);
  EXPECT_GE(best.score, climbed.score);
  EXPECT_LE(std::abs(best.shift.columns), window.cells);
  EXPECT_LE(std::abs(best.shift.rows), window.cells);
}

TEST(AlignmentSearch, MoreSearchNeverScoresLess) {
  const SearchWindow windows[] = {{3, 4, false}, {7, 8, false}, {3, kHalfCircle, true}};
  for (const SearchWindow& window : windows) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      for (const PairWeights& weights : {kWeights, kPaperWeights}) {
        // Half of the recognition grids are of another room: scores are low and maxima many.
        Trial trial = randomTrial(seed, 0.8, 0.5);
        if (seed % 2 == 0) trial.recognition = randomTrial(seed + 100, 0.8, 0.5).recognition;
        double before = -1e300;
        for (const SearchMethod method : kMethods) {  // by rising effort
          const Alignment found = align(trial, window, method, weights);
          EXPECT_GE(found.score, before) << "seed " << seed;
          before = found.score;
        }
      }
    }
  }
}

TEST(AlignmentSearch, ExhaustiveFindsTheBestOfAllTransforms) {
  const Trial trial = randomTrial(5, 0.5, 0.2);
  const SearchWindow window{4, 3, false};
  const QueryPlanes query(trial.recognition, kStep, window.rotations);
  double best = -1e300;
  for (int rotation = -window.rotations; rotation <= window.rotations; ++rotation) {
    for (int rows = -window.cells; rows <= window.cells; ++rows) {
      for (int columns = -window.cells; columns <= window.cells; ++columns) {
        best = std::max(best, scoreAt(query, trial.learned, {columns, rows}, rotation));
      }
    }
  }
  const Alignment found =
      findAlignment(query, trial.learned, {kWeights, 0.0, 0.0}, window, SearchMethod::kExhaustive);
  EXPECT_DOUBLE_EQ(found.score, best);
}

TEST(AlignmentSearch, GivesTheSameAnswerEachTime) {
  const Trial trial = randomTrial(6, 0.8, 0.5);
  for (const SearchMethod method : kMethods) {
    const Alignment first = align(trial, {6, 10, false}, method);
    const Alignment second = align(trial, {6, 10, false}, method);
    EXPECT_EQ(first.shift.columns, second.shift.columns);
    EXPECT_EQ(first.shift.rows, second.shift.rows);
    EXPECT_EQ(first.rotation, second.rotation);
    EXPECT_EQ(first.score, second.score);
  }
}

TEST(AlignmentSearch, GridsThatSayNothingAlignSomewhereInTheWindow) {
  const Trial nothing{{}, CellPlanes(EvidenceGrid()), EvidenceGrid()};
  for (const SearchMethod method : kMethods) {
    const Alignment found = align(nothing, {3, 2, false}, method);
    EXPECT_LE(std::abs(found.shift.columns), 3);
    EXPECT_LE(std::abs(found.shift.rows), 3);
    EXPECT_LE(std::abs(found.rotation), 2);
    EXPECT_DOUBLE_EQ(found.score, 0.0);
  }
}

}  // namespace
}  // namespace place_memory::core
