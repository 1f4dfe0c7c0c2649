#include "core/mapping/fused_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/mapping/known_places.h"

namespace place_memory::core {
namespace {

GridPointer fullGrid(int evidence) {
  auto grid = std::make_shared<EvidenceGrid>();
  for (auto& cell : grid->cells()) cell = static_cast<std::int8_t>(evidence);
  return grid;
}

/// Evidence of the cell that the point is in; 0 outside.
int at(const FusedCells& cells, double x, double y) {
  const int column = static_cast<int>(std::floor((x - cells.left) / cells.resolution));
  const int row = static_cast<int>(std::floor((y - cells.bottom) / cells.resolution));
  if (column < 0 || row < 0 || column >= cells.columns || row >= cells.rows) return 0;
  return cells.evidence[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns) +
                        static_cast<std::size_t>(column)];
}

double evidenceOf(const EvidenceGrid& grid, int row, int column) {
  const bool is_inside = row >= 0 && column >= 0 && row < kGridSize && column < kGridSize;
  return is_inside ? grid.at(row, column) : 0.0;
}

/// The sum as one would write it down, of places of one session that lie where poses are rounded.
int sumAt(const KnownPlaces& places, double x, double y) {
  int sum = 0;
  for (const auto& [id, known] : places) {
    const Pose2d in_place = known.place.map_from_place.inverse() * Pose2d{x, y, 0.0};
    const double size = known.grid->geometry().cell_size;
    const double column = in_place.x / size + 31.5;
    const double row = in_place.y / size + 31.5;
    const double c0 = std::floor(column), r0 = std::floor(row);
    double evidence = 0.0;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        const double weight = (1.0 - std::abs(column - c0 - j)) * (1.0 - std::abs(row - r0 - i));
        evidence +=
            weight * evidenceOf(*known.grid, static_cast<int>(r0) + i, static_cast<int>(c0) + j);
      }
    }
    sum += static_cast<int>(std::lround(evidence));
  }
  return std::clamp(sum, -127, 127);
}

TEST(FusedMap, EvidenceOfAllPlacesIsAddedUp) {
  std::mt19937 engine(3);
  FusedMapOptions options;
  options.resolution = 0.08;
  KnownPlaces places;
  const double step = options.resolution / 4.0;  // where no rounding shows
  for (PlaceId id = 1; id <= 6; ++id) {
    const double turn = static_cast<double>(id % 4) * 0.5 * kPi;
    places[id] = {makePlace(id, {static_cast<double>(id) * 70.0 * step, -40.0 * step, turn}),
                  randomGrid(engine)};
  }
  // A quarter of a circle is no whole number of steps; what is off by less than one may differ.
  const FusedCells cells = fromScratch(options, places).cells();
  ASSERT_GT(cells.columns, 100);
  std::size_t differing = 0, total = 0;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column) {
      const double x = cells.left + (column + 0.5) * cells.resolution;
      const double y = cells.bottom + (row + 0.5) * cells.resolution;
      ++total;
      if (std::abs(at(cells, x, y) - sumAt(places, x, y)) > 12) ++differing;
    }
  }
  EXPECT_LT(static_cast<double>(differing), 0.01 * static_cast<double>(total));
}

TEST(FusedMap, WithoutAPlaceItHasNoCell) {
  FusedMap map(FusedMapOptions{}, GridGeometry{});
  map.update();
  EXPECT_EQ(map.cells().columns, 0);
  map.add(makePlace(1, {}), fullGrid(30));
  map.update();
  EXPECT_GT(map.cells().columns, 0);
  MapChange change;
  change.edits = {PlaceRemoved{1}};
  map.apply(change);
  map.update();
  EXPECT_EQ(map.cells().columns, 0);
  EXPECT_TRUE(map.cells().evidence.empty());
}

TEST(FusedMap, SessionsThatAreApartAreNotMixedIn) {
  FusedMap map(FusedMapOptions{}, GridGeometry{});
  map.add(makePlace(1, {0.0, 0.0, 0.0}, 1), fullGrid(-30));
  map.add(makePlace(2, {1.0, 0.0, 0.0}, 2), fullGrid(90));
  map.update();
  EXPECT_EQ(at(map.cells(), 1.0, 0.0), -30);
  EXPECT_EQ(map.leftOut(), 0U);
  MapChange joined;
  joined.edits = {PlaceMoved{2, {20.0, 0.0, 0.0}, 1}};
  map.apply(joined);
  map.update();
  EXPECT_EQ(at(map.cells(), 20.0, 0.0), 90);
}

TEST(FusedMap, OfTheEarliestSessionAlone) {
  FusedMap map(FusedMapOptions{}, GridGeometry{});
  map.add(makePlace(5, {0.0, 0.0, 0.0}, 3), fullGrid(-30));
  map.add(makePlace(6, {0.0, 0.0, 0.0}, 4), fullGrid(90));
  map.update();
  EXPECT_EQ(at(map.cells(), 0.0, 0.0), -30);
}

TEST(FusedMap, APlaceAstrayMakesNoHugeMap) {
  FusedMap map(FusedMapOptions{}, GridGeometry{});
  for (PlaceId id = 1; id <= 5; ++id) {
    map.add(makePlace(id, {static_cast<double>(id), 0.0, 0.0}), fullGrid(-30));
  }
  map.update();
  const FusedCells before = map.cells();
  PlaceId id = 5;
  for (const double x : {1e6, -1e6, 1e12, 1e300}) {
    map.add(makePlace(++id, {x, 5.0, 1.0}), fullGrid(90));
  }
  map.update();
  expectSame(map.cells(), before);
  EXPECT_EQ(map.leftOut(), 4U);
}

TEST(FusedMap, OnePlaceAloneIsMappedWhereverItLies) {
  FusedMap map(FusedMapOptions{}, GridGeometry{});
  map.add(makePlace(1, {1e6, -1e6, 1.0}), fullGrid(-30));
  map.update();
  EXPECT_EQ(at(map.cells(), 1e6, -1e6), -30);
  EXPECT_LT(map.cells().evidence.size(), 200'000U);
}

TEST(FusedMap, MorePlacesThanItMayKeepAreThoseOfTheMiddle) {
  FusedMapOptions options;
  options.most_places = 3;
  FusedMap map(options, GridGeometry{});
  for (PlaceId id = 1; id <= 7; ++id) {
    map.add(makePlace(id, {10.0 * static_cast<double>(id), 0.0, 0.0}), fullGrid(-30));
  }
  map.update();
  EXPECT_EQ(map.leftOut(), 4U);
  EXPECT_EQ(at(map.cells(), 40.0, 0.0), -30);
  EXPECT_EQ(at(map.cells(), 70.0, 0.0), 0);
}

TEST(FusedMap, GridsAreAskedForWhereTheyAreLaid) {
  std::vector<PlaceId> asked;
  FusedMap map(FusedMapOptions{}, GridGeometry{}, [&](PlaceId id) -> GridPointer {
    asked.push_back(id);
    return id == 2 && asked.size() < 3 ? nullptr : fullGrid(30);
  });
  map.add(makePlace(1, {}));
  map.add(makePlace(2, {20.0, 0.0, 0.0}));
  map.update();
  EXPECT_EQ(asked, (std::vector<PlaceId>{1, 2}));
  EXPECT_EQ(at(map.cells(), 20.0, 0.0), 0);
  map.update();  // the one that could not be read is asked for again
  EXPECT_EQ(asked, (std::vector<PlaceId>{1, 2, 2}));
  EXPECT_EQ(at(map.cells(), 20.0, 0.0), 30);
  map.update();
  EXPECT_EQ(asked.size(), 3U);
}

TEST(FusedMap, ManyPlacesThatAgreeSaturate) {
  FusedMap map(FusedMapOptions{}, GridGeometry{});
  for (PlaceId id = 1; id <= 1000; ++id) map.add(makePlace(id, {}), fullGrid(127));
  map.update();
  EXPECT_EQ(at(map.cells(), 0.0, 0.0), 127);
  MapChange change;
  for (PlaceId id = 2; id <= 1000; ++id) change.edits.emplace_back(PlaceRemoved{id});
  change.edits.emplace_back(GridAdapted{1, fullGrid(-5)});
  map.apply(change);
  map.update();
  EXPECT_EQ(at(map.cells(), 0.0, 0.0), -5);
}

TEST(FusedMap, NamesAndLinksDoNotShow) {
  MapChange change;
  change.edits = {PlaceRenamed{1, "a"}, LinkAdded{}, LinkRemoved{1, 2}, LinkLearned{}};
  EXPECT_FALSE(showsInFusedMap(change));
  change.edits.emplace_back(PlaceMoved{1, {}, 1});
  EXPECT_TRUE(showsInFusedMap(change));
}

TEST(FusedMap, ACellIsNoFinerThanAnEighthOfAGrids) {
  FusedMapOptions options;
  options.resolution = 0.01;
  EXPECT_EQ(FusedMap(options, GridGeometry{0.2}).resolution(), 0.025);
  EXPECT_EQ(FusedMap(options, GridGeometry{0.05}).resolution(), 0.01);
  options.resolution = 0.0;
  EXPECT_THROW(FusedMap(options, GridGeometry{}), std::invalid_argument);
}

}  // namespace
}  // namespace place_memory::core
