#include "core/map/inverse_change.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "core/map/change_words.h"
#include "core/map/place_map_fixture.h"
#include "core/random_scan.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kPlenty = std::size_t{1} << 30U;

const PlaceContents kContents{
    [](PlaceId id) { return makeRandomScan(static_cast<unsigned>(id)).grid; },
    [](PlaceId) { return std::vector<SonarReading>(3); }};

MapEdit randomEdit(std::mt19937& random) {
  const auto below = [&random](unsigned limit) { return static_cast<PlaceId>(random() % limit); };
  const PlaceId one = below(8) + 1;
  const PlaceId other = below(8) + 1;
  switch (below(20)) {
    case 0:
    case 1:
    case 2:
    case 3:
      return added(one, "place " + std::to_string(below(12)));
    case 4:
    case 5:
      return PlaceRemoved{one};
    case 6:
    case 7:
      return PlaceRenamed{one, "place " + std::to_string(below(12))};
    case 8:
      return PlaceMoved{one, {static_cast<double>(below(9)), 1.0, 0.5}, below(2) + 1};
    case 9:
      return LinkRemoved{one, other};
    case 10:
    case 11:
      return LinkLearned{one, other, {static_cast<std::uint32_t>(below(9)), 1, nanoseconds(1)}};
    case 12:
      return MapCleared{};
    default:
      return LinkAdded{makeLink(one, other)};
  }
}

TEST(InverseChange, BringsBackWhatRandomChangesDid) {
  std::mt19937 random(11);
  PlaceMap map;
  int undone = 0;
  for (int i = 0; i < 4000; ++i) {
    std::vector<MapEdit> edits;
    for (int length = 1 + i % 4; length > 0; --length) edits.push_back(randomEdit(random));
    const PlaceMap before = map;
    const std::vector<MapEdit> inverse = [&] {
      try {
        map.check({map.version() + 1, nanoseconds(7), edits});
      } catch (const std::invalid_argument&) {
        return std::vector<MapEdit>();
      }
      return *inverseOf(edits, map, kContents, kPlenty);
    }();
    if (inverse.empty()) continue;
    edit(map, edits);
    PlaceMap after = map;
    try {
      edit(after, inverse);
    } catch (const std::invalid_argument&) {
      continue;  // labels that went round in a circle
    }
    ++undone;
    ASSERT_TRUE(after.places() == before.places());
    ASSERT_TRUE(after.links() == before.links());
  }
  EXPECT_GT(undone, 250);
}

TEST(InverseChange, HoldsGridsAndReadings) {
  PlaceMap map;
  edit(map, {added(1, "a"), added(2, "b")});
  const auto removed = inverseOf({PlaceRemoved{2}}, map, kContents, kPlenty);
  ASSERT_EQ(removed->size(), 1U);
  const auto& back = std::get<PlaceAdded>(removed->front());
  EXPECT_EQ(*back.grid, kContents.grid(2));
  EXPECT_EQ(back.readings->size(), 3U);
  const auto adapted =
      inverseOf({GridAdapted{1, std::make_shared<EvidenceGrid>()}}, map, kContents, kPlenty);
  EXPECT_EQ(*std::get<GridAdapted>(adapted->front()).grid, kContents.grid(1));
}

TEST(InverseChange, IsNothingWhereItWouldBeTooMuch) {
  PlaceMap map;
  edit(map, {added(1, "a"), added(2, "b")});
  EXPECT_TRUE(inverseOf({PlaceRemoved{2}}, map, kContents, 2 * kGridCells));
  EXPECT_FALSE(inverseOf({MapCleared{}}, map, kContents, 2 * kGridCells));
}

TEST(ChangeWords, SayWhatIsDone) {
  PlaceMap map;
  edit(map, {added(1, "a"), added(2, "b"), LinkAdded{makeLink(1, 2)}});
  EXPECT_EQ(editsInWords({added(3, "c"), LinkAdded{makeLink(2, 3)}}, map), "learned \"c\"");
  EXPECT_EQ(editsInWords({added(3, "c"), added(4, "d")}, map), "learned 2 places");
  EXPECT_EQ(editsInWords({PlaceRenamed{1, "z"}}, map), "renamed \"a\" to \"z\"");
  EXPECT_EQ(editsInWords({PlaceRemoved{2}}, map), "removed \"b\"");
  EXPECT_EQ(editsInWords({LinkRemoved{1, 2}}, map), "unlinked \"a\" from \"b\"");
  EXPECT_EQ(editsInWords({MapCleared{}}, map), "removed all 2 places");
  EXPECT_EQ(editsInWords({LinkLearned{1, 2, {}}}, map), "set the link \"a\" to \"b\"");
  EXPECT_EQ(editsInWords({LinkLearned{1, 2, {}, Traversal{}}}, map), "");
}

}  // namespace
}  // namespace place_memory::core
