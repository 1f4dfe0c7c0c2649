#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/store/damage.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

// What happened to single rows, and what is said of it. The second place is what they are of.
const Damage kRowDamages[] = {
    {"PlaceWithoutGrid", sql("DELETE FROM grid WHERE place_id = 2"), "the grid of place 2"},
    {"PlaceGone", sql("DELETE FROM place WHERE id = 2"), "1 places are missing"},
    {"LastPlaceGone", sql("DELETE FROM place WHERE id = 3"), "1 places are missing"},
    {"LinkGone", sql("DELETE FROM link WHERE second_id = 2"), "1 links are missing"},
    {"LinkTwice",
     sql("INSERT INTO link SELECT id + 5, first_id, second_id, x, y, yaw, covariance, "
         "forward_succeeded, forward_failed, forward_last_ns, backward_succeeded, "
         "backward_failed, backward_last_ns, forward_habit, backward_habit, checksum FROM link "
         "WHERE second_id = 2"),
     "a link of place 1 is damaged"},
    {"LinkToNowhere", sql("UPDATE link SET second_id = 77 WHERE second_id = 2"),
     "a link of place 1 is damaged"},
    {"LinkElsewhere", sql("UPDATE link SET x = x + 1 WHERE second_id = 2"),
     "a link of place 1 is damaged"},
    {"OtherHabitOfALink", sql("UPDATE link SET forward_habit = backward_habit WHERE second_id = 2"),
     "a link of place 1 is damaged"},
    {"NoHabitOfALink", sql("UPDATE link SET forward_habit = x'' WHERE second_id = 2"),
     "a link of place 1 is damaged"},
    {"TraversalGone", sql("DELETE FROM traversal WHERE to_id = 2"),
     "1 traversals of links are missing"},
    {"TraversalOfAnother", sql("UPDATE traversal SET succeeded = 0 WHERE to_id = 2"),
     "1 traversals of links are damaged"},
    {"OtherLabel", sql("UPDATE place SET label = 'cttic' WHERE id = 2"), "\"cttic\""},
    {"EmptyLabel", sql("UPDATE place SET label = '' WHERE id = 2"), "place 2 is damaged"},
    {"ControlCharacterInLabel", sql("UPDATE place SET label = char(7) WHERE id = 2"),
     "place 2 is damaged"},
    {"OtherId", sql("UPDATE place SET id = 77 WHERE id = 2"), "place 77 is damaged"},
    {"InfiniteLocation", sql("UPDATE place SET x = 9e999 WHERE id = 2"), "place 2 is damaged"},
    {"OtherYaw", sql("UPDATE place SET yaw = -3e77 WHERE id = 2"), "place 2 is damaged"},
    {"ShortGrid", sql("UPDATE grid SET cells = x'00' WHERE place_id = 2"), "the grid of place 2"},
    {"GridOfNull", sql("UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2"),
     "the grid of place 2"},
    {"GridOfAnother",
     sql("UPDATE grid SET cells = (SELECT cells FROM grid WHERE place_id = 1), checksum = "
         "(SELECT checksum FROM grid WHERE place_id = 1) WHERE place_id = 2"),
     "the grid of place 2"},
    {"PlaceWithoutPlanes", sql("DELETE FROM planes"), "the bit planes of place 2"},
    {"ShortPlanes", sql("UPDATE planes SET slots = x'00'"), "the bit planes of place 2"},
    {"PlanesOfNull", sql("UPDATE planes SET slots = zeroblob(length(slots))"),
     "the bit planes of place 2"},
    {"NoHead", sql("DELETE FROM store"), "the store's own row"},
    {"OtherNextId", sql("UPDATE store SET next_place = 2"), "the store's own row"},
    {"OtherCellSize", sql("UPDATE store SET cell_size = 0.2"), "the store's own row"},
};

bool says(const PlaceStore& store, const std::string& words) {
  for (const std::string& sentence : store.setAside()) {
    if (sentence.find(words) != std::string::npos) return true;
  }
  return false;
}

// What is served is what was written, or is not there.
void expectNothingWrong(const PlaceStore& store) {
  const PlaceMap map = store.map();
  for (const Place& place : map.places()) {
    EXPECT_EQ(
        place,
        addition(place.id, makePlace(std::string(1, "abc"[place.id - 1])), EvidenceGrid()).place);
  }
  for (const PlaceLink& link : map.links()) EXPECT_EQ(link, makeLink(link.first, link.second));
  store.forEachGrid([](PlaceId id, const EvidenceGrid& grid) {
    EXPECT_EQ(grid, makeGrid(static_cast<unsigned>(id)));
  });
  store.forEachPlanes([](PlaceId id, const CellPlanes& planes) {
    const CellPlanes expected(makeGrid(static_cast<unsigned>(id)));
    EXPECT_EQ(planes.occupied, expected.occupied);
    EXPECT_EQ(planes.empty, expected.empty);
  });
}

class DamagedRowTest : public PlaceStoreTest, public testing::WithParamInterface<Damage> {};

TEST_P(DamagedRowTest, IsNamedAndTheRestServes) {
  fill();
  GetParam().inflict(path_);
  const std::string before = readFile(path_);
  {
    const PlaceStore store = open();
    EXPECT_TRUE(says(store, GetParam().message)) << testing::PrintToString(store.setAside());
    EXPECT_GE(store.map().size(), 2U);
    expectNothingWrong(store);
  }
  EXPECT_EQ(readFile(path_), before);
}

TEST_P(DamagedRowTest, GetsNoWorseByAChange) {
  fill();
  GetParam().inflict(path_);
  std::vector<std::string> before;
  std::vector<Place> places;
  {
    PlaceStore store = open();
    before = store.setAside();
    places = store.map().places();
    const PlaceId added = add(store, makePlace("d"), makeGrid(4), 1);
    EXPECT_GE(added, 4);
    commit(store, {PlaceRemoved{added}});
    const PlaceId other = add(store, makePlace("d"), makeGrid(4), kNoPlace);
    EXPECT_GT(other, added);
    commit(store, {PlaceRemoved{other}});
    expectNothingWrong(store);
  }
  const PlaceStore store = open();
  EXPECT_LE(store.setAside().size(), before.size());
  EXPECT_EQ(store.map().places(), places);
  expectNothingWrong(store);
}

TEST_P(DamagedRowTest, IsGoneWhereAllIsCleared) {
  fill();
  GetParam().inflict(path_);
  {
    PlaceStore store = open();
    commit(store, {MapCleared{}});
    add(store, makePlace("d"), makeGrid(4), kNoPlace);
  }
  EXPECT_TRUE(open().setAside().empty());
  EXPECT_EQ(open().map().size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedRowTest, testing::ValuesIn(kRowDamages),
                         [](const auto& damage) { return std::string(damage.param.name); });

TEST_F(PlaceStoreTest, MakesDamagedBitPlanesAnewFromTheGrid) {
  fill();
  runSql(path_, "UPDATE planes SET slots = zeroblob(length(slots))");
  const PlaceStore store = open();
  std::size_t places = 0;
  store.forEachPlanes([&places](PlaceId, const CellPlanes&) { ++places; });
  EXPECT_EQ(places, 3U);
}

TEST_F(PlaceStoreTest, AGridThatIsPutInThePlaceOfADamagedOneMendsIt) {
  fill();
  runSql(path_,
         "UPDATE grid SET cells = x'00' WHERE place_id = 2; "
         "UPDATE planes SET slots = zeroblob(length(slots))");
  {
    PlaceStore store = open();
    EXPECT_THROW(store.grid(2), StoreError);
    for (PlaceId id = 1; id <= 3; ++id) update(store, id, makeGrid(static_cast<unsigned>(id)));
  }
  const PlaceStore store = open();
  expectNothingWrong(store);
  EXPECT_FALSE(says(store, "place")) << testing::PrintToString(store.setAside());
}

// A store that is too large to be checked in full at every start.
class LargeStoreTest : public PlaceStoreTest {
 protected:
  PlaceStore openLarge() {
    StoreOpening opening;
    opening.full_check_size = 0;
    opening.progress = [this](const std::string& sentence) { said_ += sentence + '\n'; };
    return PlaceStore(path_, kDefaultCellSize, opening);
  }

  // Returns what was found to be damaged.
  std::vector<std::string> readAllButGrids() {
    const PlaceStore store = openLarge();
    store.map();
    store.forEachPlanes([](PlaceId, const CellPlanes&) {});
    store.traversals();
    return store.setAside();
  }

  std::string said_;
};

TEST_F(LargeStoreTest, IsReadWithoutBeingChecked) {
  fill();
  EXPECT_TRUE(readAllButGrids().empty());
  EXPECT_EQ(said_, "");
}

TEST_F(LargeStoreTest, FindsDamageInWhatIsRead) {
  for (const Damage& damage : kRowDamages) {
    if (std::string(damage.message) == "the grid of place 2") continue;
    fs::remove(path_);
    fill();
    damage.inflict(path_);
    EXPECT_FALSE(readAllButGrids().empty()) << damage.name;
  }
}

TEST_F(LargeStoreTest, FindsDamageOfAGridWhenItIsAskedFor) {
  fill();
  runSql(path_, "UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2");
  EXPECT_TRUE(readAllButGrids().empty());
  const PlaceStore store = openLarge();
  EXPECT_THROW(store.grid(2), StoreError);
  EXPECT_EQ(store.grid(3), makeGrid(3));
}

TEST_F(LargeStoreTest, RefusesAStoreOfOtherCells) {
  { const PlaceStore store(path_, 0.2); }
  try {
    openLarge();
    FAIL() << "the store was taken";
  } catch (const StoreError& error) {
    EXPECT_NE(std::string(error.what()).find("cells of 0.2"), std::string::npos) << error.what();
  }
}

TEST_F(LargeStoreTest, IsCheckedInFullWhereItsLastUserDidNotEndWell) {
  fill();
  runSql(path_, "DELETE FROM grid WHERE place_id = 2");
  EXPECT_TRUE(openLarge().setAside().empty());
  writeFile(path_ + "-journal", "");
  EXPECT_FALSE(openLarge().setAside().empty());
  EXPECT_NE(said_.find("checking"), std::string::npos) << said_;
}

}  // namespace
}  // namespace place_memory::core
