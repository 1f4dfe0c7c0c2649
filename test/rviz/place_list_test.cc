#include "rviz/place_list.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace place_memory::panel {
namespace {

using Labels = std::vector<std::string>;

Place makePlace(std::int64_t id, const std::string& label) {
  Place place;
  place.id = id;
  place.label = label;
  place.session = 1;
  return place;
}

MapChange makeChange(std::uint64_t version) {
  MapChange change;
  change.version = version;
  return change;
}

PlaceGraph makeGraph(std::uint64_t version) {
  PlaceGraph graph;
  graph.version = version;
  graph.places = {makePlace(1, "hall"), makePlace(2, "lab")};
  return graph;
}

Labels labels(const PlaceList& list) {
  Labels found;
  for (const PlaceRow& row : *list.rows()) found.push_back(row.label);
  return found;
}

TEST(PlaceList, BeforeTheWholeIsKnownItIsToBeAskedFor) {
  PlaceList list;
  EXPECT_FALSE(list.apply(makeChange(1)));
  EXPECT_TRUE(list.rows()->empty());
}

TEST(PlaceList, ChangesAreDoneInTheirOrder) {
  PlaceList list;
  list.reset(makeGraph(7));
  MapChange change = makeChange(8);
  change.removed = {1};
  change.added = {makePlace(5, "yard"), makePlace(3, "stairs")};
  change.moved = {2};
  change.moved_locations.resize(1);
  change.moved_locations[0].x = 4.0;
  change.moved_sessions = {2};
  change.renamed = {5};
  change.new_labels = {"garden"};
  EXPECT_TRUE(list.apply(change));
  EXPECT_EQ(labels(list), (Labels{"lab", "stairs", "garden"}));
  EXPECT_EQ(list.rows()->front().x, 4.0);
  EXPECT_EQ(list.rows()->front().session, 2);
}

TEST(PlaceList, WhatIsClearedComesBeforeWhatIsAdded) {
  PlaceList list;
  list.reset(makeGraph(1));
  MapChange change = makeChange(2);
  change.cleared = true;
  change.added = {makePlace(9, "new")};
  EXPECT_TRUE(list.apply(change));
  EXPECT_EQ(labels(list), Labels{"new"});
}

TEST(PlaceList, AChangeThatTheWholeHoldsAlreadyChangesNothing) {
  PlaceList list;
  list.reset(makeGraph(7));
  const auto before = list.rows();
  MapChange change = makeChange(7);
  change.cleared = true;
  EXPECT_TRUE(list.apply(change));
  EXPECT_EQ(list.rows(), before);
}

TEST(PlaceList, AfterAGapTheWholeIsToBeAskedFor) {
  PlaceList list;
  list.reset(makeGraph(7));
  MapChange change = makeChange(9);
  change.cleared = true;
  EXPECT_FALSE(list.apply(change));
  EXPECT_EQ(labels(list).size(), 2U);
}

TEST(PlaceList, AChangeThatFitsNoPlaceAndIsCutShortIsSurvived) {
  PlaceList list;
  list.reset(makeGraph(1));
  MapChange change = makeChange(2);
  change.removed = {77};
  change.moved = {1, 2, 77};
  change.moved_locations.resize(1);
  change.renamed = {77, 1};
  change.new_labels = {"lost"};
  EXPECT_TRUE(list.apply(change));
  EXPECT_EQ(labels(list), (Labels{"hall", "lab"}));
}

}  // namespace
}  // namespace place_memory::panel
