#include "place_memory/core/place_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

namespace place_memory::core {
namespace {

Place makePlace(PlaceId id, const std::string& label) {
  Place place;
  place.id = id;
  place.label = label;
  return place;
}

PlaceGraph makeTriangle() {
  PlaceGraph graph;
  graph.add(makePlace(1, "a"));
  graph.add(makePlace(2, "b"));
  graph.add(makePlace(3, "c"));
  graph.link(1, 2);
  graph.link(3, 2);
  graph.link(3, 1);
  return graph;
}

std::vector<PlaceId> idsOf(const PlaceGraph& graph) {
  std::vector<PlaceId> ids;
  for (const Place& place : graph.places()) ids.push_back(place.id);
  return ids;
}

TEST(PlaceGraph, StartsEmpty) {
  const PlaceGraph graph;
  EXPECT_EQ(graph.size(), 0U);
  EXPECT_EQ(graph.lastId(), kNoPlace);
  EXPECT_TRUE(graph.places().empty());
  EXPECT_TRUE(graph.links().empty());
  EXPECT_EQ(graph.find(1), nullptr);
  EXPECT_EQ(graph.find("a"), nullptr);
}

TEST(PlaceGraph, FindsPlacesByIdAndByLabel) {
  const PlaceGraph graph = makeTriangle();
  ASSERT_NE(graph.find(2), nullptr);
  EXPECT_EQ(graph.find(2)->label, "b");
  ASSERT_NE(graph.find("c"), nullptr);
  EXPECT_EQ(graph.find("c")->id, 3);
  EXPECT_EQ(graph.lastId(), 3);
}

TEST(PlaceGraph, ALinkHasNoDirectionAndIsThereOnce) {
  PlaceGraph graph = makeTriangle();
  graph.link(2, 1);
  EXPECT_EQ(graph.links(), (std::vector<PlaceLink>{{1, 2}, {1, 3}, {2, 3}}));
}

TEST(PlaceGraph, RemovingAPlaceRemovesItsLinksAndFreesItsLabel) {
  PlaceGraph graph = makeTriangle();
  graph.remove(1);
  EXPECT_EQ(idsOf(graph), (std::vector<PlaceId>{2, 3}));
  EXPECT_EQ(graph.links(), (std::vector<PlaceLink>{{2, 3}}));
  EXPECT_EQ(graph.find("a"), nullptr);
  EXPECT_NO_THROW(graph.add(makePlace(4, "a")));
}

TEST(PlaceGraph, RenamingMovesTheLabelAndKeepsTheRest) {
  PlaceGraph graph = makeTriangle();
  graph.rename(1, "z");
  EXPECT_EQ(graph.find("a"), nullptr);
  ASSERT_NE(graph.find("z"), nullptr);
  EXPECT_EQ(graph.find("z")->id, 1);
  EXPECT_EQ(graph.links().size(), 3U);
  EXPECT_NO_THROW(graph.rename(1, "z"));
}

TEST(PlaceGraph, RefusesWhatWouldBreakIt) {
  PlaceGraph graph = makeTriangle();
  EXPECT_THROW(graph.add(makePlace(1, "new")), std::invalid_argument);
  EXPECT_THROW(graph.add(makePlace(9, "a")), std::invalid_argument);
  EXPECT_THROW(graph.rename(1, "b"), std::invalid_argument);
  EXPECT_THROW(graph.rename(9, "new"), std::invalid_argument);
  EXPECT_THROW(graph.link(1, 1), std::invalid_argument);
  EXPECT_THROW(graph.link(1, 9), std::invalid_argument);
  EXPECT_EQ(idsOf(graph), (std::vector<PlaceId>{1, 2, 3}));
  EXPECT_EQ(graph.find("new"), nullptr);
  EXPECT_EQ(graph.links().size(), 3U);
}

TEST(PlaceGraph, ACopyIsASnapshot) {
  PlaceGraph graph = makeTriangle();
  const PlaceGraph snapshot = graph;
  graph.clear();
  EXPECT_EQ(graph.size(), 0U);
  EXPECT_EQ(idsOf(snapshot), (std::vector<PlaceId>{1, 2, 3}));
  EXPECT_EQ(snapshot.links().size(), 3U);
}

// Against a list of places and a list of links that are searched through.
TEST(PlaceGraph, AgreesWithPlainListsAfterRandomEdits) {
  std::mt19937 random(7);
  PlaceGraph graph;
  std::set<PlaceId> ids;
  std::set<std::pair<PlaceId, PlaceId>> links;
  for (int i = 0; i < 3000; ++i) {
    const PlaceId one = static_cast<PlaceId>(random() % 40) + 1;
    const PlaceId other = static_cast<PlaceId>(random() % 40) + 1;
    const auto edit = random() % 4;
    if (edit == 0) {
      graph.remove(one);
      ids.erase(one);
      for (auto link = links.begin(); link != links.end();) {
        link = link->first == one || link->second == one ? links.erase(link) : std::next(link);
      }
    } else if (edit == 1 && ids.insert(one).second) {
      graph.add(makePlace(one, "place " + std::to_string(one)));
    } else if (one != other && ids.count(one) != 0 && ids.count(other) != 0) {
      graph.link(one, other);
      links.insert(std::minmax(one, other));
    }
  }
  ASSERT_FALSE(links.empty());
  EXPECT_EQ(idsOf(graph), std::vector<PlaceId>(ids.begin(), ids.end()));
  std::vector<PlaceLink> expected;
  for (const auto& [first, second] : links) expected.push_back({first, second});
  EXPECT_EQ(graph.links(), expected);
}

}  // namespace
}  // namespace place_memory::core
