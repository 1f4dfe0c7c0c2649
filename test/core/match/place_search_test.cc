#include "core/match/place_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/random_room.h"

namespace place_memory::core {
namespace {

constexpr SearchWindow kWindow{5, 6, false};
constexpr SearchWindow kAnyHeading{3, kHalfCircle, true};
const LatticeMetric kMetric{{{{1.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, {-2.0, -1.0, 3.0}}}, 0.01, 0.02};
constexpr PlaceId kRooms = 30;

CellPlanes roomCells(PlaceId id) {
  return CellPlanes(RandomRoom(static_cast<unsigned>(id)).scanFrom({}).grid);
}

/// Places 1 to kRooms are rooms; the others have their lower rows of one room and their upper ones
/// of another.
PlaceIndex spliced(std::size_t places) {
  std::vector<CellPlanes> rooms;
  for (PlaceId id = 1; id <= kRooms; ++id) rooms.push_back(roomCells(id));
  PlaceIndex index;
  std::mt19937 engine(51);
  for (std::size_t i = 0; i < places; ++i) {
    CellPlanes cells = rooms[i % rooms.size()];
    if (i >= rooms.size()) {
      const CellPlanes& other = rooms[static_cast<std::size_t>(engine()) % rooms.size()];
      const auto from = static_cast<std::size_t>(engine()) % kGridSize;
      std::copy(other.occupied.begin() + static_cast<std::ptrdiff_t>(from), other.occupied.end(),
                cells.occupied.begin() + static_cast<std::ptrdiff_t>(from));
      std::copy(other.empty.begin() + static_cast<std::ptrdiff_t>(from), other.empty.end(),
                cells.empty.begin() + static_cast<std::ptrdiff_t>(from));
    }
    index.put(static_cast<PlaceId>(i + 1), cells);
  }
  return index;
}

EvidenceGrid scanIn(PlaceId id, std::mt19937& engine, double rotation) {
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const Pose2d pose{0.4 * share(engine), 0.4 * share(engine), rotation * share(engine)};
  return RandomRoom(static_cast<unsigned>(id)).scanFrom(pose).grid;
}

std::vector<PlaceAlignment> search(const EvidenceGrid& grid, const PlaceIndex& places,
                                   const SearchWindow& window, support::WorkerPool& pool,
                                   SearchMethod method = SearchMethod::kRestarts) {
  const QueryPlanes query(grid, kHeadingStep, window.rotations);
  return searchPlaces(query, places, kMetric, window, method, nullptr, pool);
}

void expectSame(const std::vector<PlaceAlignment>& a, const std::vector<PlaceAlignment>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].place, b[i].place) << i;
    ASSERT_EQ(a[i].alignment.score, b[i].alignment.score) << i;
    ASSERT_EQ(a[i].alignment.rotation, b[i].alignment.rotation) << i;
    ASSERT_EQ(a[i].alignment.shift.columns, b[i].alignment.shift.columns) << i;
    ASSERT_EQ(a[i].alignment.shift.rows, b[i].alignment.shift.rows) << i;
  }
}

void expectRanked(const std::vector<PlaceAlignment>& found) {
  for (std::size_t i = 1; i < found.size(); ++i) {
    const double before = found[i - 1].alignment.score;
    ASSERT_GE(before, found[i].alignment.score) << i;
    if (before == found[i].alignment.score) {
      ASSERT_LT(found[i - 1].place, found[i].place) << i;
    }
  }
}

TEST(PlaceSearch, FindsWhatTheExhaustiveSearchFinds) {
  std::mt19937 engine(61);
  support::WorkerPool pool(2);
  for (const std::size_t size : {std::size_t{30}, std::size_t{1500}}) {
    const PlaceIndex places = spliced(size);
    for (PlaceId id = 1; id <= 8; ++id) {
      const EvidenceGrid grid = scanIn(id, engine, 0.25);
      const auto found = search(grid, places, kWindow, pool);
      const auto best = search(grid, places, kWindow, pool, SearchMethod::kExhaustive);
      EXPECT_EQ(found.front().place, best.front().place) << size;
      EXPECT_EQ(found.front().alignment.score, best.front().alignment.score) << size;
    }
  }
}

TEST(PlaceSearch, FindsWhatTheExhaustiveSearchFindsAtAnyHeading) {
  std::mt19937 engine(62);
  support::WorkerPool pool(2);
  const PlaceIndex places = spliced(kRooms);
  for (PlaceId id = 1; id <= 5; ++id) {
    const EvidenceGrid grid = scanIn(id, engine, kPi);
    const auto found = search(grid, places, kAnyHeading, pool);
    const auto best = search(grid, places, kAnyHeading, pool, SearchMethod::kExhaustive);
    EXPECT_EQ(found.front().place, best.front().place);
    EXPECT_EQ(found.front().alignment.score, best.front().alignment.score);
  }
}

TEST(PlaceSearch, TakesPairsWhereGridsOverlapAlone) {
  LatticeMetric metric;
  metric.overlap_only = true;
  std::mt19937 engine(70);
  support::WorkerPool pool(2);
  const PlaceIndex places = spliced(100);
  for (PlaceId id = 1; id <= 3; ++id) {
    const QueryPlanes query(scanIn(id, engine, 0.25), kHeadingStep, kWindow.rotations);
    const auto found =
        searchPlaces(query, places, metric, kWindow, SearchMethod::kRestarts, nullptr, pool);
    const auto best =
        searchPlaces(query, places, metric, kWindow, SearchMethod::kExhaustive, nullptr, pool);
    ASSERT_EQ(found.size(), places.size());
    EXPECT_EQ(found.front().place, best.front().place);
    EXPECT_EQ(found.front().alignment.score, best.front().alignment.score);
  }
}

TEST(PlaceSearch, TheNumberOfThreadsDoesNotMatter) {
  std::mt19937 engine(63);
  const PlaceIndex places = spliced(1300);
  const EvidenceGrid grid = scanIn(4, engine, 0.25);
  for (const SearchMethod method : {SearchMethod::kRestarts, SearchMethod::kHillClimbing}) {
    support::WorkerPool alone(1);
    const auto expected = search(grid, places, kWindow, alone, method);
    for (const std::size_t threads : {std::size_t{2}, std::size_t{5}}) {
      support::WorkerPool pool(threads);
      for (int round = 0; round < 3; ++round) {
        expectSame(search(grid, places, kWindow, pool, method), expected);
      }
    }
  }
}

TEST(PlaceSearch, TellsHowManyEvaluationsItTookWhateverTheThreads) {
  std::mt19937 engine(71);
  double of_few = 0.0;
  for (const std::size_t size : {std::size_t{30}, std::size_t{1300}}) {
    const PlaceIndex places = spliced(size);
    const QueryPlanes query(scanIn(4, engine, 0.25), kHeadingStep, kWindow.rotations);
    std::vector<double> evaluations;
    for (const std::size_t threads : {std::size_t{1}, std::size_t{2}, std::size_t{5}}) {
      support::WorkerPool pool(threads);
      SearchEffort effort;
      searchPlaces(query, places, kMetric, kWindow, SearchMethod::kRestarts, nullptr, pool,
                   &effort);
      evaluations.push_back(effort.evaluations / static_cast<double>(size));
    }
    EXPECT_EQ(evaluations[0], evaluations[1]);
    EXPECT_EQ(evaluations[0], evaluations[2]);
    if (size == 30) of_few = evaluations[0];
    EXPECT_GT(evaluations[0], 1.0);
    EXPECT_LE(evaluations[0], of_few);
  }
}

TEST(PlaceSearch, RanksEveryPlaceOfAnUsualMemory) {
  std::mt19937 engine(64);
  support::WorkerPool pool(2);
  for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{100}, kMostRanked}) {
    const PlaceIndex places = spliced(size);
    const auto found = search(scanIn(2, engine, 0.25), places, kWindow, pool);
    ASSERT_EQ(found.size(), size);
    expectRanked(found);
    std::vector<PlaceId> ids;
    for (const PlaceAlignment& place : found) ids.push_back(place.place);
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(ids[i], static_cast<PlaceId>(i + 1));
  }
}

TEST(PlaceSearch, RanksTheBestOfVeryMany) {
  std::mt19937 engine(65);
  support::WorkerPool pool(2);
  const PlaceIndex places = spliced(kMostRanked + 200);
  for (const SearchMethod method : {SearchMethod::kRestarts, SearchMethod::kNearestNeighbour}) {
    const auto found = search(scanIn(3, engine, 0.25), places, kWindow, pool, method);
    EXPECT_EQ(found.size(), kMostRanked);
    expectRanked(found);
  }
}

TEST(PlaceSearch, TellsWhatEachAlignmentScores) {
  std::mt19937 engine(66);
  support::WorkerPool pool(2);
  const PlaceIndex places = spliced(300);
  const QueryPlanes query(scanIn(5, engine, 0.25), kHeadingStep, kWindow.rotations);
  for (const PlaceAlignment& place :
       searchPlaces(query, places, kMetric, kWindow, SearchMethod::kRestarts, nullptr, pool)) {
    const Alignment& at = place.alignment;
    const CellPlanes cells = places.cells(place.place);
    const PairCounts counts = countPairs(query.at(at.rotation), at.shift, cells);
    const int shift = at.shift.columns * at.shift.columns + at.shift.rows * at.shift.rows;
    EXPECT_NEAR(at.score,
                pairScore(counts, kMetric.weights) - kMetric.shift_cost * shift -
                    kMetric.rotation_cost * at.rotation * at.rotation,
                1e-9);
  }
}

TEST(PlaceSearch, TheFirstPlacesStandOnSummits) {
  std::mt19937 engine(67);
  support::WorkerPool pool(2);
  const PlaceIndex places = spliced(600);
  const QueryPlanes query(scanIn(6, engine, 0.25), kHeadingStep, kWindow.rotations);
  const auto found =
      searchPlaces(query, places, kMetric, kWindow, SearchMethod::kRestarts, nullptr, pool);
  for (std::size_t i = 0; i < kSurelyClimbed; ++i) {
    const Alignment& at = found[i].alignment;
    const CellPlanes cells = places.cells(found[i].place);
    for (const int by : {-1, 1}) {
      const CellShift aside{at.shift.columns + by, at.shift.rows};
      const CellShift ahead{at.shift.columns, at.shift.rows + by};
      if (std::abs(aside.columns) <= kWindow.cells) {
        EXPECT_LE(scoreAt(query, cells, kMetric, aside, at.rotation), at.score) << i;
      }
      if (std::abs(ahead.rows) <= kWindow.cells) {
        EXPECT_LE(scoreAt(query, cells, kMetric, ahead, at.rotation), at.score) << i;
      }
      if (std::abs(at.rotation + by) <= kWindow.rotations) {
        EXPECT_LE(scoreAt(query, cells, kMetric, at.shift, at.rotation + by), at.score) << i;
      }
    }
  }
}

TEST(PlaceSearch, EqualPlacesGoByTheirIds) {
  support::WorkerPool pool(2);
  const CellPlanes room = roomCells(7);
  PlaceIndex places;
  for (PlaceId id = 1200; id >= 1; --id) places.put(id, room);
  std::mt19937 engine(68);
  const auto found = search(scanIn(7, engine, 0.25), places, kWindow, pool);
  ASSERT_EQ(found.size(), kMostRanked);
  for (std::size_t i = 0; i < kSurelyClimbed; ++i) {
    EXPECT_EQ(found[i].place, static_cast<PlaceId>(i + 1));
  }
}

TEST(PlaceSearch, NoPlacesAreNoAnswer) {
  support::WorkerPool pool(2);
  for (const SearchMethod method : {SearchMethod::kRestarts, SearchMethod::kExhaustive}) {
    EXPECT_TRUE(search(EvidenceGrid(), PlaceIndex(), kWindow, pool, method).empty());
  }
}

TEST(PlaceSearch, StopsWhereverItIsCancelled) {
  std::mt19937 engine(69);
  support::WorkerPool pool(1);  // other threads might leave the caller no task to poll after
  const PlaceIndex places = spliced(1300);
  const QueryPlanes query(scanIn(6, engine, 0.25), kHeadingStep, kWindow.rotations);
  for (const int last : {1, 2, 4, 7}) {
    int polls = 0;
    const auto cancelled = [&] { return ++polls >= last; };
    EXPECT_THROW(
        searchPlaces(query, places, kMetric, kWindow, SearchMethod::kRestarts, cancelled, pool),
        std::runtime_error);
    EXPECT_EQ(polls, last);
  }
}

}  // namespace
}  // namespace place_memory::core
