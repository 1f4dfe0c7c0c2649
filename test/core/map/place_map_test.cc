#include "place_memory/core/place_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/map/place_map_fixture.h"

namespace place_memory::core {
namespace {

PlaceMap makeTriangle() {
  return PlaceMap({makePlace(1, "a"), makePlace(2, "b"), makePlace(3, "c")},
                  {makeLink(1, 2), makeLink(2, 3), makeLink(1, 3)}, 5, nanoseconds(55));
}

TEST(PlaceMap, StartsEmpty) {
  const PlaceMap map;
  EXPECT_EQ(map.size(), 0U);
  EXPECT_EQ(map.version(), 0U);
  EXPECT_EQ(map.stamp(), nanoseconds(0));
  EXPECT_EQ(map.lastId(), kNoPlace);
  EXPECT_TRUE(map.places().empty());
  EXPECT_TRUE(map.links().empty());
  EXPECT_EQ(map.find(1), nullptr);
  EXPECT_EQ(map.find("a"), nullptr);
}

TEST(PlaceMap, IsAsItWasKept) {
  const PlaceMap map = makeTriangle();
  EXPECT_EQ(map.version(), 5U);
  EXPECT_EQ(map.stamp(), nanoseconds(55));
  ASSERT_NE(map.find(2), nullptr);
  EXPECT_EQ(map.find(2)->label, "b");
  ASSERT_NE(map.find("c"), nullptr);
  EXPECT_EQ(map.find("c")->id, 3);
  EXPECT_EQ(map.lastId(), 3);
  EXPECT_EQ(endsOf(map), (Ends{{1, 2}, {1, 3}, {2, 3}}));
  EXPECT_EQ(map.neighbours(2), (Ids{1, 3}));
}

TEST(PlaceMap, AChangeBringsItsVersionAndStamp) {
  PlaceMap map = makeTriangle();
  map.apply({6, nanoseconds(66), {added(9, "z"), PlaceRenamed{1, "y"}}});
  EXPECT_EQ(map.version(), 6U);
  EXPECT_EQ(map.stamp(), nanoseconds(66));
  EXPECT_EQ(map.size(), 4U);
  EXPECT_EQ(map.find("y")->id, 1);
}

TEST(PlaceMap, AChangeThatWasMissedIsNoticed) {
  PlaceMap map = makeTriangle();
  EXPECT_THROW(map.apply({7, nanoseconds(0), {added(9, "z")}}), std::invalid_argument);
  EXPECT_THROW(map.apply({5, nanoseconds(0), {added(9, "z")}}), std::invalid_argument);
  expectSame(map, makeTriangle());
}

TEST(PlaceMap, APlaceKeepsItsOrderWhateverItsId) {
  PlaceMap map = makeTriangle();
  edit(map, {added(20, "x")});
  edit(map, {added(10, "y")});
  EXPECT_EQ(idsOf(map), (Ids{1, 2, 3, 10, 20}));
  EXPECT_EQ(map.find(10)->label, "y");
  EXPECT_EQ(map.find(20)->label, "x");
}

TEST(PlaceMap, MovingChangesPoseAndSessionAlone) {
  PlaceMap map = makeTriangle();
  edit(map, {PlaceMoved{2, {3.0, 4.0, 0.5}, 8}});
  Place expected = makePlace(2, "b");
  expected.map_from_place = {3.0, 4.0, 0.5};
  expected.session = 8;
  EXPECT_TRUE(*map.find(2) == expected);
  EXPECT_TRUE(map.links() == makeTriangle().links());
}

TEST(PlaceMap, RemovingAPlaceRemovesItsLinksAndFreesItsLabel) {
  PlaceMap map = makeTriangle();
  edit(map, {PlaceRemoved{1}, added(4, "a")});
  EXPECT_EQ(idsOf(map), (Ids{2, 3, 4}));
  EXPECT_EQ(endsOf(map), (Ends{{2, 3}}));
  EXPECT_EQ(map.find("a")->id, 4);
  EXPECT_EQ(map.neighbours(2), (Ids{3}));
}

TEST(PlaceMap, RenamingMovesTheLabelAndKeepsTheRest) {
  PlaceMap map = makeTriangle();
  edit(map, {PlaceRenamed{1, "z"}});
  EXPECT_EQ(map.find("a"), nullptr);
  EXPECT_EQ(map.find("z")->id, 1);
  EXPECT_EQ(map.links().size(), 3U);
  EXPECT_NO_THROW(edit(map, {PlaceRenamed{1, "z"}}));
}

TEST(PlaceMap, LabelsCanBeSwappedInOneChange) {
  PlaceMap map = makeTriangle();
  edit(map, {PlaceRenamed{1, "for a moment"}, PlaceRenamed{2, "a"}, PlaceRenamed{1, "b"}});
  EXPECT_EQ(map.find("a")->id, 2);
  EXPECT_EQ(map.find("b")->id, 1);
  EXPECT_EQ(map.find("for a moment"), nullptr);
}

TEST(PlaceMap, ALinkIsThereOnceAndTheNewestCounts) {
  PlaceMap map = makeTriangle();
  PlaceLink link = makeLink(1, 2);
  link.first_from_second = {9.0, 9.0, 0.9};
  edit(map, {LinkAdded{link}});
  EXPECT_EQ(map.links().size(), 3U);
  EXPECT_TRUE(*map.findLink(2, 1) == link);
  edit(map, {LinkRemoved{2, 1}});
  EXPECT_EQ(map.findLink(1, 2), nullptr);
  EXPECT_EQ(map.neighbours(1), (Ids{3}));
}

TEST(PlaceMap, EachWayOfALinkIsLearnedByItself) {
  PlaceMap map = makeTriangle();
  edit(map, {LinkLearned{1, 2, {3, 1, nanoseconds(5)}}});
  edit(map, {LinkLearned{2, 1, {0, 2, nanoseconds(6)}}});
  EXPECT_TRUE((map.findLink(1, 2)->forward == LinkDirection{3, 1, nanoseconds(5)}));
  EXPECT_TRUE((map.findLink(1, 2)->backward == LinkDirection{0, 2, nanoseconds(6)}));
  EXPECT_TRUE(map.findLink(1, 3)->forward == LinkDirection{});
}

TEST(PlaceMap, ClearedItIsEmptyButForItsVersion) {
  PlaceMap map = makeTriangle();
  edit(map, {MapCleared{}, added(9, "a")});
  EXPECT_EQ(idsOf(map), (Ids{9}));
  EXPECT_TRUE(map.links().empty());
  EXPECT_EQ(map.version(), 6U);
}

// Whatever comes before it in the same change, what does not fit changes nothing at all.
TEST(PlaceMap, RefusesWhatDoesNotFitAsAWhole) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Place adrift = makePlace(9, "adrift");
  adrift.map_from_place.x = nan;
  Place nowhere = makePlace(9, "of no session");
  nowhere.session = kNoSession;
  PlaceLink vague = makeLink(1, 2);
  vague.covariance[4] = nan;
  const std::vector<MapEdit> wrong{
      added(1, "new"),
      added(0, "no id"),
      added(9, "c"),
      added(9, ""),
      added(9, std::string("\x01")),
      PlaceAdded{adrift, nullptr, nullptr},
      PlaceAdded{nowhere, nullptr, nullptr},
      added(10, "just added"),
      PlaceMoved{9, {}, 1},
      PlaceMoved{1, {0.0, nan, 0.0}, 1},
      PlaceMoved{1, {}, kNoSession},
      PlaceRenamed{1, "c"},
      PlaceRenamed{1, "just added"},
      PlaceRenamed{9, "new"},
      GridAdapted{9, nullptr},
      PlaceRemoved{9},
      PlaceRemoved{2},  // which is gone by then
      LinkAdded{makeLink(1, 1)},
      LinkAdded{makeLink(1, 2)},
      LinkAdded{makeLink(1, 9)},
      LinkAdded{makeLink(3, 1)},
      LinkAdded{vague},
      LinkRemoved{1, 2},
      LinkLearned{2, 3, {}},
      LinkLearned{1, 9, {}},
  };
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    PlaceMap map = makeTriangle();
    const std::vector<MapEdit> edits{added(10, "just added"), PlaceRemoved{2},
                                     LinkLearned{1, 3, {1, 0, nanoseconds(1)}}, wrong[i]};
    EXPECT_THROW(edit(map, edits), std::invalid_argument) << "edit " << i;
    expectSame(map, makeTriangle());
  }
}

TEST(PlaceMap, RefusesToBeMadeOfWhatDoesNotFit) {
  EXPECT_THROW(PlaceMap({makePlace(1, "a"), makePlace(2, "a")}, {}, 0, {}), std::invalid_argument);
  EXPECT_THROW(PlaceMap({makePlace(1, "a")}, {makeLink(1, 2)}, 0, {}), std::invalid_argument);
}

TEST(PlaceMap, ACopyIsASnapshot) {
  PlaceMap map = makeTriangle();
  const PlaceMap snapshot = map;
  edit(map, {MapCleared{}});
  EXPECT_EQ(map.size(), 0U);
  expectSame(snapshot, makeTriangle());
}

}  // namespace
}  // namespace place_memory::core
