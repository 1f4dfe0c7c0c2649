#include "place_memory/core/place_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include "place_memory/core/map_change.h"

namespace place_memory::core {
namespace {

using std::chrono::nanoseconds;

Place makePlace(PlaceId id, const std::string& label) {
  Place place;
  place.id = id;
  place.label = label;
  return place;
}

PlaceLink makeLink(PlaceId first, PlaceId second) {
  PlaceLink link;
  link.first = first;
  link.second = second;
  link.first_from_second = {1.0, 2.0, 0.3};
  return link;
}

MapEdit added(PlaceId id, const std::string& label) {
  return PlaceAdded{makePlace(id, label), nullptr, nullptr};
}

void edit(PlaceMap& map, std::vector<MapEdit> edits) {
  map.apply({map.version() + 1, nanoseconds(7), std::move(edits)});
}

PlaceMap makeTriangle() {
  return PlaceMap({makePlace(1, "a"), makePlace(2, "b"), makePlace(3, "c")},
                  {makeLink(1, 2), makeLink(2, 3), makeLink(1, 3)}, 5, nanoseconds(55));
}

std::vector<PlaceId> idsOf(const PlaceMap& map) {
  std::vector<PlaceId> ids;
  for (const Place& place : map.places()) ids.push_back(place.id);
  return ids;
}

std::vector<std::pair<PlaceId, PlaceId>> endsOf(const PlaceMap& map) {
  std::vector<std::pair<PlaceId, PlaceId>> ends;
  for (const PlaceLink& link : map.links()) ends.emplace_back(link.first, link.second);
  return ends;
}

using Ends = std::vector<std::pair<PlaceId, PlaceId>>;
using Ids = std::vector<PlaceId>;

void expectSame(const PlaceMap& one, const PlaceMap& other) {
  EXPECT_EQ(one.version(), other.version());
  EXPECT_EQ(one.stamp(), other.stamp());
  EXPECT_TRUE(one.places() == other.places());
  EXPECT_TRUE(one.links() == other.links());
  for (const Place& place : one.places()) {
    EXPECT_EQ(other.find(place.label), other.find(place.id));
    EXPECT_EQ(one.neighbours(place.id), other.neighbours(place.id));
  }
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
  PlaceLink vague = makeLink(1, 2);
  vague.covariance[4] = nan;
  const std::vector<MapEdit> wrong{
      added(1, "new"),
      added(0, "no id"),
      added(9, "c"),
      added(9, ""),
      added(9, std::string("\x01")),
      PlaceAdded{adrift, nullptr, nullptr},
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

/// A set of places and a set of links that are searched through.
class PlainMap {
 public:
  /// Whether the edit fits; then it is made.
  bool add(PlaceId id) { return ids_.insert(id).second; }
  bool remove(PlaceId id) {
    for (auto link = links_.begin(); link != links_.end();) {
      link = link->first == id || link->second == id ? links_.erase(link) : std::next(link);
    }
    return ids_.erase(id) > 0;
  }
  bool link(PlaceId one, PlaceId other) {
    if (one >= other || ids_.count(one) == 0 || ids_.count(other) == 0) return false;
    links_.insert({one, other});
    return true;
  }
  bool unlink(PlaceId one, PlaceId other) { return links_.erase(std::minmax(one, other)) > 0; }
  bool learn(PlaceId one, PlaceId other) const { return links_.count(std::minmax(one, other)) > 0; }
  void clear() {
    ids_.clear();
    links_.clear();
  }

  Ids ids() const { return Ids(ids_.begin(), ids_.end()); }
  Ends ends() const { return Ends(links_.begin(), links_.end()); }

 private:
  std::set<PlaceId> ids_;
  std::set<std::pair<PlaceId, PlaceId>> links_;
};

class RandomEdits {
 public:
  /// A random edit, made in `plain` where it fits; whether it does.
  std::pair<MapEdit, bool> next(PlainMap& plain) {
    const PlaceId one = id();
    const PlaceId other = id();
    switch (random_() % 9) {
      case 0:
      case 1:
      case 2:
        return {added(one, "place " + std::to_string(one)), plain.add(one)};
      case 3:
        return {PlaceRemoved{one}, plain.remove(one)};
      case 4:
        return {LinkRemoved{one, other}, plain.unlink(one, other)};
      case 5:
        return {LinkLearned{one, other, {1, 1, nanoseconds(1)}}, plain.learn(one, other)};
      case 6:
        if (random_() % 100 == 0) {
          plain.clear();
          return {MapCleared{}, true};
        }
        [[fallthrough]];
      default:
        return {LinkAdded{makeLink(one, other)}, plain.link(one, other)};
    }
  }

 private:
  PlaceId id() { return static_cast<PlaceId>(random_() % 20) + 1; }

  std::mt19937 random_{7};
};

TEST(PlaceMap, AgreesWithPlainSetsAfterRandomChanges) {
  RandomEdits random;
  PlaceMap map;
  PlainMap plain;
  int made = 0;
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    PlainMap after = plain;
    std::vector<MapEdit> edits;
    bool fits = true;
    for (int length = 1 + i % 3; length > 0; --length) {
      const auto [one, one_fits] = random.next(after);
      edits.push_back(one);
      fits = fits && one_fits;
    }
    if (fits) {
      edit(map, edits);
      plain = after;
      ++made;
    } else {
      EXPECT_THROW(edit(map, edits), std::invalid_argument);
      ++refused;
    }
    ASSERT_EQ(idsOf(map), plain.ids());
    ASSERT_EQ(endsOf(map), plain.ends());
    ASSERT_EQ(map.version(), static_cast<std::uint64_t>(made));
    expectSame(map, PlaceMap(map.places(), map.links(), map.version(), map.stamp()));
  }
  EXPECT_GT(made, 300);
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace place_memory::core
