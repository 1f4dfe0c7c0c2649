#include "core/store/store_history.h"

#include <gtest/gtest.h>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

class StoreHistoryTest : public PlaceStoreTest {
 protected:
  static HistoryEdit entry(std::uint64_t version, std::vector<MapEdit> inverse = {}) {
    HistoryEdit edit;
    edit.add = HistoryEdit::Row{
        {version, std::chrono::nanoseconds(5), "did " + std::to_string(version), true},
        std::move(inverse)};
    return edit;
  }

  static void commit(PlaceStore& store, std::vector<MapEdit> edits, const HistoryEdit& history) {
    MapChange change;
    change.version = history.add ? history.add->change.version : 1000;
    change.edits = std::move(edits);
    store.commit(change, history);
  }

  static std::vector<std::string> words(const PlaceStore& store, std::size_t most = 1000) {
    std::vector<std::string> words;
    for (const PastChange& change : store.history(most)) words.push_back(change.words);
    return words;
  }
};

std::vector<MapEdit> everyEdit() {
  std::vector<SonarReading> readings(1);
  readings.front() = {{0.5, -0.25, 1.0}, {0.5, 0.25, 4.0}, 2.0};
  PlaceAdded place = addition(7, makePlace("k\u00fcche"), makeGrid(3));
  place.readings = std::make_shared<const std::vector<SonarReading>>(readings);
  return {place,
          PlaceMoved{3, {1.0, -2.0, 0.5}, 4},
          PlaceRenamed{3, "x"},
          GridAdapted{3, std::make_shared<EvidenceGrid>(makeGrid(2))},
          PlaceRemoved{8},
          LinkAdded{makeLink(3, 7)},
          LinkRemoved{1, 2},
          LinkLearned{2, 1, {4, 5, std::chrono::nanoseconds(6)}},
          MapCleared{}};
}

TEST_F(StoreHistoryTest, KeepsEveryKindOfEdit) {
  {
    PlaceStore store = open();
    commit(store, {}, entry(1, everyEdit()));
  }
  const PlaceStore store = open();
  EXPECT_TRUE(store.setAside().empty());
  const auto inverse = store.inverse(1);
  ASSERT_TRUE(inverse);
  ASSERT_EQ(inverse->size(), 9U);
  const auto expected = everyEdit();
  const auto& place = std::get<PlaceAdded>(inverse->at(0));
  EXPECT_TRUE(place.place == std::get<PlaceAdded>(expected[0]).place);
  EXPECT_EQ(*place.grid, makeGrid(3));
  ASSERT_EQ(place.readings->size(), 1U);
  EXPECT_EQ(place.readings->front().range, 2.0);
  EXPECT_EQ(std::get<PlaceMoved>(inverse->at(1)).map_from_place, (Pose2d{1.0, -2.0, 0.5}));
  EXPECT_EQ(std::get<PlaceMoved>(inverse->at(1)).session, 4);
  EXPECT_EQ(std::get<PlaceRenamed>(inverse->at(2)).label, "x");
  EXPECT_EQ(*std::get<GridAdapted>(inverse->at(3)).grid, makeGrid(2));
  EXPECT_EQ(std::get<PlaceRemoved>(inverse->at(4)).id, 8);
  EXPECT_TRUE(std::get<LinkAdded>(inverse->at(5)).link == makeLink(3, 7));
  EXPECT_EQ(std::get<LinkRemoved>(inverse->at(6)).second, 2);
  EXPECT_TRUE(std::get<LinkLearned>(inverse->at(7)).direction ==
              std::get<LinkLearned>(expected[7]).direction);
  EXPECT_TRUE(std::holds_alternative<MapCleared>(inverse->at(8)));
}

TEST_F(StoreHistoryTest, IsReadNewestFirstAndRowsGoAsTheyAreUndone) {
  PlaceStore store = open();
  for (const std::uint64_t version : {1U, 2U, 5U}) commit(store, {}, entry(version));
  EXPECT_EQ(words(store), (std::vector<std::string>{"did 5", "did 2", "did 1"}));
  EXPECT_EQ(words(store, 1), (std::vector<std::string>{"did 5"}));
  HistoryEdit undo;
  undo.remove = {5, 2};
  commit(store, {}, undo);
  EXPECT_EQ(words(store), (std::vector<std::string>{"did 1"}));
  EXPECT_FALSE(store.inverse(5));
}

TEST_F(StoreHistoryTest, HasTheNewest200Changes) {
  {
    PlaceStore store = open();
    for (std::uint64_t version = 1; version <= 230; ++version) commit(store, {}, entry(version));
    EXPECT_EQ(words(store).size(), 200U);
    EXPECT_EQ(words(store).back(), "did 31");
  }
  EXPECT_TRUE(open().setAside().empty());
}

TEST_F(StoreHistoryTest, OutlivesThatTheMapIsCleared) {
  {
    PlaceStore store = open();
    commit(store, {addition(1, makePlace("a"), makeGrid(1))}, entry(1));
    commit(store, {MapCleared{}}, entry(2));
  }
  const PlaceStore store = open();
  EXPECT_TRUE(store.setAside().empty());
  EXPECT_EQ(words(store).size(), 2U);
}

TEST_F(StoreHistoryTest, ADamagedRowIsNamedAndCannotBeUndone) {
  {
    PlaceStore store = open();
    commit(store, {}, entry(1, {PlaceRenamed{1, "a"}}));
    commit(store, {}, entry(2, {PlaceRenamed{1, "b"}}));
  }
  runSql(path_, "UPDATE history SET change = x'00' WHERE version = 1");
  const PlaceStore store = open();
  ASSERT_EQ(store.setAside().size(), 1U);
  EXPECT_NE(store.setAside().front().find("history of change 1"), std::string::npos);
  EXPECT_EQ(words(store), (std::vector<std::string>{"did 2"}));
  EXPECT_FALSE(store.inverse(1));
}

}  // namespace
}  // namespace place_memory::core
