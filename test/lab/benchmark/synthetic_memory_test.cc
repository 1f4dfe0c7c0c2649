#include "benchmark/synthetic_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "benchmark/spliced_places.h"

namespace place_memory::measure {
namespace {

/// Cells of each class: empty, unsensed, occupied.
std::array<int, 3> classCounts(const core::EvidenceGrid& grid) {
  std::array<int, 3> counts{};
  for (const std::int8_t cell : grid.cells()) ++counts[cell > 0 ? 2 : (cell < 0 ? 0 : 1)];
  return counts;
}

class SyntheticMemoryTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { simulated_ = new SimulatedPlaces(simulatePlaces(60)); }
  static void TearDownTestSuite() { delete simulated_; }

  static const SimulatedPlaces* simulated_;
};

const SimulatedPlaces* SyntheticMemoryTest::simulated_ = nullptr;

TEST_F(SyntheticMemoryTest, SimulatesAsManyPlacesAsAskedForTheSameOnesEachTime) {
  ASSERT_EQ(simulated_->places.size(), 60U);
  const SimulatedPlaces fewer = simulatePlaces(25);
  ASSERT_EQ(fewer.places.size(), 25U);
  for (std::size_t i = 0; i < fewer.places.size(); ++i) {
    EXPECT_EQ(fewer.places[i].grid, simulated_->places[i].grid);
    EXPECT_EQ(fewer.places[i].map_from_place.x, simulated_->places[i].map_from_place.x);
  }
}

TEST_F(SyntheticMemoryTest, EveryQueryHasAPlaceThatIsRight) {
  for (const auto* queries : {&simulated_->local, &simulated_->any_heading}) {
    EXPECT_GT(queries->size(), 50U);
    for (const Query& query : *queries) {
      ASSERT_FALSE(query.accept.empty());
      for (const std::size_t place : query.accept) {
        ASSERT_LT(place, simulated_->places.size());
        const core::Pose2d& at = simulated_->places[place].map_from_place;
        const core::Pose2d& scan = query.scan.odom_from_scan;
        EXPECT_LT(std::hypot(at.x - scan.x, at.y - scan.y), 2.0);
      }
    }
  }
}

TEST_F(SyntheticMemoryTest, GivesEveryPlaceOnceByRisingId) {
  const SyntheticMemory memory(*simulated_, 40);
  core::PlaceId expected = 1;
  memory.forEach([&](core::PlaceId id, const KnownPlace& place) {
    EXPECT_EQ(id, expected++);
    EXPECT_EQ(place.grid, simulated_->places[static_cast<std::size_t>(id) - 1].grid);
  });
  EXPECT_EQ(expected, 41);
  const KnownMap map = memory.map();
  EXPECT_EQ(map.index.size(), 40U);
  const auto frames = map.lookUp()({40, 7});
  ASSERT_TRUE(frames && frames->size() == 2);
  EXPECT_EQ((*frames)[0].map_from_place.x, simulated_->places[39].map_from_place.x);
  EXPECT_EQ((*frames)[1].map_from_place.x, simulated_->places[6].map_from_place.x);
}

TEST_F(SyntheticMemoryTest, AsksOnlyForPlacesThatItHas) {
  const SyntheticMemory memory(*simulated_, 40);
  const auto queries = memory.queries(10, false);
  EXPECT_EQ(std::set<const Query*>(queries.begin(), queries.end()).size(), 10U);
  for (const Query* query : queries) {
    const core::PlaceId right = static_cast<core::PlaceId>(query->accept.front()) + 1;
    EXPECT_LE(right, 40);
    EXPECT_TRUE(memory.isRight(*query, right));
    EXPECT_FALSE(memory.isRight(*query, right == 40 ? 1 : 40));
  }
}

TEST_F(SyntheticMemoryTest, SplicedPlacesAreOtherPlacesOfTheSameKind) {
  const SplicedPlaces spliced(simulated_->places, 1);
  std::array<double, 3> simulated_cells{}, spliced_cells{};
  constexpr std::uint64_t kCount = 200;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const KnownPlace place = spliced.make(i);
    EXPECT_EQ(place.grid, spliced.make(i).grid);
    EXPECT_GE(place.building, 1U);
    EXPECT_FALSE(place.grid == spliced.make(i + kCount).grid);
    const auto counts = classCounts(place.grid);
    for (std::size_t c = 0; c < 3; ++c) spliced_cells[c] += counts[c] / double{kCount};
  }
  std::size_t used = 0;
  for (const KnownPlace& place : simulated_->places) {
    if (place.building < 1) continue;
    ++used;
    const auto counts = classCounts(place.grid);
    for (std::size_t c = 0; c < 3; ++c) simulated_cells[c] += counts[c];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const double mean = simulated_cells[c] / static_cast<double>(used);
    EXPECT_NEAR(spliced_cells[c], mean, 0.3 * mean);
  }
}

TEST_F(SyntheticMemoryTest, RefusesToSpliceWithoutABuilding) {
  EXPECT_THROW(SplicedPlaces(simulated_->places, 1000), std::invalid_argument);
}

}  // namespace
}  // namespace place_memory::measure
