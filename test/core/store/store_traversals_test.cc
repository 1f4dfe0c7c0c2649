#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "core/store/later_store_fixture.h"

namespace place_memory::core {
namespace {

using std::chrono::nanoseconds;

class StoreTraversalsTest : public PlaceStoreTest {};

TEST_F(StoreTraversalsTest, AreKeptInTheOrderInWhichTheyWereMade) {
  fill();
  {
    PlaceStore store = open();
    LinkLearned learned{2, 1, {}, makeTraversal(2, 1)};
    learned.direction.blocked = 1.0;
    commit(store, {learned, LinkLearned{1, 2, {}}});  // a person's word is no traversal
  }
  const PlaceStore store = open();
  const std::vector<Traversal> wanted{makeTraversal(1, 2), makeTraversal(2, 3),
                                      makeTraversal(2, 1)};
  EXPECT_EQ(store.traversals(), wanted);
  EXPECT_EQ(store.map().findLink(1, 2)->backward.blocked, 1.0);
  EXPECT_TRUE(store.setAside().empty());
}

TEST_F(StoreTraversalsTest, OutliveTheirPlacesAndGoWithTheMap) {
  fill();
  PlaceStore store = open();
  commit(store, {PlaceRemoved{2}});
  EXPECT_EQ(store.traversals().size(), 2U);
  commit(store, {MapCleared{}});
  EXPECT_TRUE(store.traversals().empty());
  EXPECT_TRUE(store.setAside().empty());
}

TEST_F(StoreTraversalsTest, OneThatIsDamagedIsLeftOut) {
  fill();
  runSql(path_, "UPDATE traversal SET end_ns = end_ns + 1 WHERE to_id = 2");
  EXPECT_EQ(open().traversals(), (std::vector<Traversal>{makeTraversal(2, 3)}));
}

TEST_F(StoreTraversalsTest, AStoreOfFormat4IsBroughtToThisOneAndKeptBesideIt) {
  fill();
  const PlaceIdentity identity = open().identity();
  const std::vector<Place> places = open().map().places();
  makeFormat4(path_);
  const std::string before = readFile(path_);
  std::string said;
  StoreOpening opening;
  opening.progress = [&](const std::string& sentence) { said += sentence; };
  {
    const PlaceStore store(path_, kDefaultCellSize, opening);
    EXPECT_EQ(store.identity(), identity);
    EXPECT_EQ(store.map().places(), places);
    EXPECT_TRUE(store.traversals().empty());
    EXPECT_TRUE(store.setAside().empty());
    EXPECT_EQ(store.grid(2), makeGrid(2));
  }
  EXPECT_NE(said.find("from format 4 to 5; the old file is kept as " + path_ + ".format-4"),
            std::string::npos)
      << said;
  EXPECT_EQ(readFile(path_ + ".format-4"), before);
}

// All that format 4 knew of a traversal is that there was one.
TEST_F(StoreTraversalsTest, WhatFormat4CountedIsEvidenceNow) {
  fill();
  makeFormat4(path_);
  PlaceStore store = open();
  const PlaceMap map = store.map();
  PlaceLink wanted = makeLink(1, 2);
  wanted.forward = {3, 1, nanoseconds(77), 3.0, 1.0};
  wanted.backward = {1, 0, nanoseconds(99), 1.0};
  EXPECT_EQ(*map.findLink(1, 2), wanted);
  wanted.forward.time = 9.0;
  commit(store, {LinkLearned{1, 2, wanted.forward, makeTraversal(1, 2)}});
  EXPECT_EQ(*store.map().findLink(1, 2), wanted);
}

TEST_F(StoreTraversalsTest, ADamagedLinkOfFormat4IsNamedAfterItWasBroughtOver) {
  fill();
  makeFormat4(path_);
  runSql(path_, "UPDATE link SET forward_failed = 7 WHERE second_id = 2");
  const PlaceStore store = open();
  EXPECT_EQ(store.map().links().size(), 1U);
  ASSERT_FALSE(store.setAside().empty());
  EXPECT_NE(store.setAside()[0].find("a link of place 1 is damaged"), std::string::npos);
}

TEST_F(StoreTraversalsTest, AStoreOfFormat4WithOtherCellsIsLeftAsItIs) {
  fill();
  makeFormat4(path_);
  const std::string before = readFile(path_);
  EXPECT_THROW(PlaceStore(path_, 2.0 * kDefaultCellSize), StoreError);
  EXPECT_EQ(readFile(path_), before);
  EXPECT_FALSE(std::filesystem::exists(path_ + ".format-4"));
}

}  // namespace
}  // namespace place_memory::core
