#include "place_memory/core/place_store.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <iterator>
#include <optional>
#include <thread>

#include "random_scan.h"
#include "temporary_folder.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

Place makePlace(const std::string& label) {
  Place place;
  place.label = label;
  place.map_from_place = {1.25, -7.5, 0.3};
  place.learned = std::chrono::nanoseconds(1234567890123456789);
  return place;
}

EvidenceGrid makeGrid(unsigned seed) { return makeRandomScan(seed).grid; }

void runSql(const std::string& path, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  sqlite3_close(database);
}

class PlaceStoreTest : public testing::Test {
 protected:
  PlaceStore open() const { return PlaceStore(path_, kDefaultCellSize); }

  // A store of three places in a chain.
  void fill() const {
    PlaceStore store = open();
    const PlaceId a = store.add(makePlace("a"), makeGrid(1), kNoPlace);
    const PlaceId b = store.add(makePlace("b"), makeGrid(2), a);
    store.add(makePlace("c"), makeGrid(3), b);
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("places.db");
};

TEST_F(PlaceStoreTest, GivesBackWhatWasAdded) {
  PlaceStore store("", kDefaultCellSize);
  const PlaceId a = store.add(makePlace("a"), makeGrid(1), kNoPlace);
  const PlaceId b = store.add(makePlace("b"), makeGrid(2), a);
  const PlaceGraph graph = store.graph();
  ASSERT_EQ(graph.size(), 2U);
  const Place& place = *graph.find(a);
  EXPECT_EQ(place.label, "a");
  EXPECT_EQ(place.map_from_place.x, 1.25);
  EXPECT_EQ(place.map_from_place.y, -7.5);
  EXPECT_EQ(place.map_from_place.yaw, 0.3);
  EXPECT_EQ(place.learned.count(), 1234567890123456789);
  EXPECT_EQ(graph.links(), (std::vector<PlaceLink>{{a, b}}));
  EXPECT_EQ(store.grid(a), makeGrid(1));
  EXPECT_EQ(store.grid(b), makeGrid(2));
  EXPECT_THROW(store.grid(99), StoreError);
}

TEST_F(PlaceStoreTest, ReadsEveryGridInTheOrderOfIds) {
  fill();
  std::vector<PlaceId> ids;
  open().forEachGrid([&ids](PlaceId id, const EvidenceGrid& grid) {
    ids.push_back(id);
    EXPECT_EQ(grid, makeGrid(static_cast<unsigned>(ids.size())));
  });
  EXPECT_EQ(ids, (std::vector<PlaceId>{1, 2, 3}));
}

TEST_F(PlaceStoreTest, ReadsThePlanesOfEveryGridAsItIsNow) {
  fill();
  PlaceStore store = open();
  store.update(3, makeGrid(7));
  store.remove(1);
  std::vector<PlaceId> ids;
  store.forEachPlanes([&](PlaceId id, const CellPlanes& planes) {
    ids.push_back(id);
    const CellPlanes expected(store.grid(id));
    EXPECT_EQ(planes.occupied, expected.occupied);
    EXPECT_EQ(planes.empty, expected.empty);
  });
  EXPECT_EQ(ids, (std::vector<PlaceId>{2, 3}));
}

TEST_F(PlaceStoreTest, MakesManyChangesAtOnce) {
  PlaceStore store = open();
  store.atOnce([&store] {
    store.add(makePlace("a"), makeGrid(1), kNoPlace);
    store.add(makePlace("b"), makeGrid(2), 1);
    store.rename(1, "z");
  });
  EXPECT_EQ(store.graph().find(1)->label, "z");
  EXPECT_EQ(store.graph().links().size(), 1U);
}

TEST_F(PlaceStoreTest, UndoesAllOfTheChangesAtOnceWhereOneFails) {
  fill();
  PlaceStore store = open();
  const auto changes = [&store] {
    store.remove(1);
    store.add(makePlace("d"), makeGrid(4), kNoPlace);
    store.rename(2, "c");  // which another place is called
  };
  EXPECT_THROW(store.atOnce(changes), StoreError);
  EXPECT_EQ(store.graph().size(), 3U);
  EXPECT_EQ(store.grid(1), makeGrid(1));
  EXPECT_NO_THROW(store.rename(1, "z"));
}

TEST_F(PlaceStoreTest, RenamesRemovesAndClears) {
  fill();
  PlaceStore store = open();
  store.rename(1, "z");
  store.remove(2);
  PlaceGraph graph = store.graph();
  EXPECT_EQ(graph.size(), 2U);
  EXPECT_EQ(graph.find("z")->id, 1);
  EXPECT_TRUE(graph.links().empty());
  EXPECT_THROW(store.grid(2), StoreError);
  store.clear();
  EXPECT_EQ(store.graph().size(), 0U);
  EXPECT_THROW(store.grid(1), StoreError);
}

TEST_F(PlaceStoreTest, PutsAnotherGridInThePlaceOfTheOneAPlaceHas) {
  fill();
  {
    PlaceStore store = open();
    store.update(2, makeGrid(7));
    EXPECT_THROW(store.update(99, makeGrid(8)), StoreError);
  }
  const PlaceStore store = open();
  EXPECT_EQ(store.grid(1), makeGrid(1));
  EXPECT_EQ(store.grid(2), makeGrid(7));
  EXPECT_EQ(store.graph().size(), 3U);
}

TEST_F(PlaceStoreTest, AGridThatCannotBeUpdatedStays) {
  fill();
  runSql(path_, "CREATE TRIGGER full AFTER UPDATE ON grid BEGIN SELECT RAISE(ABORT, 'full'); END");
  PlaceStore store = open();
  EXPECT_THROW(store.update(2, makeGrid(7)), StoreError);
  EXPECT_EQ(store.grid(2), makeGrid(2));
}

TEST_F(PlaceStoreTest, NeverGivesAnIdAgain) {
  fill();
  {
    PlaceStore store = open();
    store.remove(3);
    EXPECT_EQ(store.add(makePlace("d"), makeGrid(4), kNoPlace), 4);
    store.clear();
  }
  EXPECT_EQ(open().add(makePlace("e"), makeGrid(5), kNoPlace), 5);
}

TEST_F(PlaceStoreTest, EveryChangeIsInTheFileWhenTheCallReturns) {
  PlaceStore store = open();
  const std::string copy = folder_.file("copy.db");
  const auto expect_in_file = [&](const std::vector<std::string>& labels) {
    fs::copy_file(path_, copy, fs::copy_options::overwrite_existing);
    std::vector<std::string> found;
    for (const Place& place : PlaceStore(copy, kDefaultCellSize).graph().places()) {
      found.push_back(place.label);
    }
    EXPECT_EQ(found, labels);
  };
  store.add(makePlace("a"), makeGrid(1), kNoPlace);
  expect_in_file({"a"});
  store.add(makePlace("b"), makeGrid(2), 1);
  expect_in_file({"a", "b"});
  store.rename(1, "z");
  expect_in_file({"z", "b"});
  store.remove(1);
  expect_in_file({"b"});
  store.clear();
  expect_in_file({});
}

TEST_F(PlaceStoreTest, AChangeThatFailsHalfWayLeavesNothing) {
  fill();
  runSql(path_, "CREATE TRIGGER full BEFORE INSERT ON link BEGIN SELECT RAISE(ABORT, 'full'); END");
  PlaceStore store = open();
  EXPECT_THROW(store.add(makePlace("d"), makeGrid(4), 1), StoreError);
  EXPECT_EQ(store.graph().size(), 3U);
  EXPECT_THROW(store.grid(4), StoreError);
  EXPECT_NO_THROW(store.add(makePlace("d"), makeGrid(4), kNoPlace));
}

TEST_F(PlaceStoreTest, RefusesALabelTwice) {
  fill();
  PlaceStore store = open();
  EXPECT_THROW(store.add(makePlace("a"), makeGrid(4), kNoPlace), StoreError);
  EXPECT_THROW(store.rename(1, "b"), StoreError);
  EXPECT_EQ(store.graph().size(), 3U);
}

TEST_F(PlaceStoreTest, KeepsOneFileOnly) {
  fill();
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_EQ(names, std::vector<std::string>{"places.db"});
}

TEST_F(PlaceStoreTest, AnUnfinishedNewStoreDoesNotStandInTheWay) {
  writeFile(path_ + ".new", "cut off");
  EXPECT_EQ(open().graph().size(), 0U);
}

TEST_F(PlaceStoreTest, OfManyThatCreateItAtOnceOneHasIt) {
  for (int round = 0; round < 3; ++round) {
    const std::string path = folder_.file("places-" + std::to_string(round) + ".db");
    std::atomic<int> ready{0}, held{0};
    std::atomic<bool> all_tried{false};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&, i] {
        for (++ready; ready < 4;) std::this_thread::yield();
        try {
          PlaceStore store(path, kDefaultCellSize);
          store.add(makePlace("of " + std::to_string(i)), makeGrid(1), kNoPlace);
          ++held;
          ++ready;
          while (!all_tried) std::this_thread::yield();
        } catch (const StoreError&) {
          ++ready;
        }
      });
    }
    while (ready < 8) std::this_thread::yield();
    all_tried = true;
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(held, 1);
    EXPECT_EQ(PlaceStore(path, kDefaultCellSize).graph().size(), 1U);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(path_).parent_path()), {}), 3);
}

TEST_F(PlaceStoreTest, IsHeldByOneAtATime) {
  const PlaceStore store = open();
  try {
    open();
    FAIL() << "two have the store";
  } catch (const StoreError& error) {
    EXPECT_NE(std::string(error.what()).find("in use"), std::string::npos) << error.what();
  }
}

TEST_F(PlaceStoreTest, RefusesChangesWhereTheFileWasDeleted) {
  fill();
  PlaceStore store = open();
  fs::remove(path_);
  EXPECT_THROW(store.add(makePlace("d"), makeGrid(4), kNoPlace), StoreError);
  EXPECT_THROW(store.rename(1, "e"), StoreError);
  EXPECT_EQ(store.graph().size(), 3U);
}

TEST_F(PlaceStoreTest, RefusesChangesWhereAnotherFileStandsInThePlace) {
  fill();
  PlaceStore store = open();
  fs::rename(path_, folder_.file("elsewhere.db"));
  fill();
  EXPECT_THROW(store.remove(1), StoreError);
  EXPECT_EQ(open().graph().size(), 3U);
}

TEST_F(PlaceStoreTest, TakesACellSizeThatWentThroughText) {
  fill();
  EXPECT_NO_THROW(PlaceStore(path_, 0.142875));
}

/// What format 1 did not have.
constexpr char kToFormat1[] = "DROP TABLE planes; PRAGMA user_version = 1;";

TEST_F(PlaceStoreTest, TakesAStoreOfFormat1) {
  fill();
  runSql(path_, kToFormat1);
  for (int opening = 0; opening < 2; ++opening) {
    const PlaceStore store = open();
    EXPECT_EQ(store.graph().links().size(), 2U);
    std::size_t places = 0;
    store.forEachPlanes([&](PlaceId id, const CellPlanes& planes) {
      EXPECT_EQ(planes.occupied, CellPlanes(makeGrid(static_cast<unsigned>(id))).occupied);
      ++places;
    });
    EXPECT_EQ(places, 3U);
  }
}

// What happened to a good store, and what its refusal says.
struct Damage {
  const char* name;
  std::function<void(const std::string& path)> inflict;
  const char* message;
};

void PrintTo(const Damage& damage, std::ostream* out) { *out << damage.name; }

std::function<void(const std::string&)> sql(const std::string& statements) {
  return [statements](const std::string& path) { runSql(path, statements); };
}

std::function<void(const std::string&)> cutTo(double share) {
  return [share](const std::string& path) {
    const std::string bytes = readFile(path);
    writeFile(path,
              bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
  };
}

std::function<void(const std::string&)> replaceBy(const std::string& bytes) {
  return [bytes](const std::string& path) { writeFile(path, bytes); };
}

std::function<void(const std::string&)> scribbleAt(std::size_t offset) {
  return [offset](const std::string& path) {
    std::string bytes = readFile(path);
    bytes.replace(offset, 600, 600, '\x5a');
    writeFile(path, bytes);
  };
}

const Damage kDamages[] = {
    {"Empty", cutTo(0.0), "cut short"},
    {"CutToHalfAHeader",
     [](const std::string& path) { writeFile(path, readFile(path).substr(0, 50)); }, "cut short"},
    {"CutToHalf", cutTo(0.5), "cut short"},
    {"CutByAByte", cutTo(0.99999), "cut short"},
    {"Text", replaceBy(std::string(5000, 'x')), "is not a place store"},
    {"ShortText", replaceBy("label,x,y\n"), "cut short"},
    {"OtherDatabase", sql("PRAGMA application_id = 7"), "is not a place store"},
    {"NewerVersion", sql("PRAGMA user_version = 3"), "newer version"},
    {"ScribbledSchema", scribbleAt(110), "damaged"},
    {"ScribbledTable", scribbleAt(65536), "damaged"},
    {"NoTables", sql("DROP TABLE link; DROP TABLE grid; DROP TABLE planes; DROP TABLE place"),
     "no such table"},
    {"PlaceWithoutGrid", sql("DELETE FROM grid WHERE place_id = 2"), "damaged"},
    {"GridWithoutPlace", sql("DELETE FROM place WHERE id = 2"), "damaged"},
    {"LinkToNowhere", sql("INSERT INTO link VALUES(1, 77)"), "damaged"},
    {"EmptyLabel", sql("UPDATE place SET label = '' WHERE id = 2"), "damaged"},
    {"ControlCharacterInLabel", sql("UPDATE place SET label = char(7) WHERE id = 2"), "damaged"},
    {"InfiniteLocation", sql("UPDATE place SET x = 9e999 WHERE id = 2"), "damaged"},
    {"ShortGrid", sql("UPDATE grid SET cells = x'00' WHERE place_id = 2"), "damaged"},
    {"GridOfNull", sql("UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2"), "damaged"},
    {"PlaceWithoutPlanes", sql("DELETE FROM planes WHERE place_id = 2"), "damaged"},
    {"ShortPlanes", sql("UPDATE planes SET cells = x'00' WHERE place_id = 2"), "damaged"},
    {"PlanesOfNull", sql("UPDATE planes SET cells = zeroblob(1024) WHERE place_id = 2"), "damaged"},
    {"ShortGridOfFormat1",
     sql(std::string(kToFormat1) + "UPDATE grid SET cells = x'00' WHERE place_id = 2"), "damaged"},
    {"OtherCellSize", sql("UPDATE grid SET cell_size = 0.2 WHERE place_id = 2"), "cells of 0.2"},
    {"OtherCellSizeOfFormat1",
     sql(std::string(kToFormat1) + "UPDATE grid SET cell_size = 0.2 WHERE place_id = 2"),
     "cells of 0.2"},
};

class DamagedStoreTest : public PlaceStoreTest, public testing::WithParamInterface<Damage> {};

TEST_P(DamagedStoreTest, IsRefusedWithTheReasonAndLeftAsItIs) {
  fill();
  GetParam().inflict(path_);
  const std::string before = readFile(path_);
  try {
    const PlaceStore store = open();
    store.graph();
    store.forEachGrid([](PlaceId, const EvidenceGrid&) {});
    store.forEachPlanes([](PlaceId, const CellPlanes&) {});
    FAIL() << "the store was taken";
  } catch (const StoreError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(path_), std::string::npos) << message;
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
  }
  EXPECT_EQ(readFile(path_), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedStoreTest, testing::ValuesIn(kDamages),
                         [](const auto& damage) { return std::string(damage.param.name); });

// A store that is too large to be checked in full at every start.
class LargeStoreTest : public PlaceStoreTest {
 protected:
  PlaceStore openLarge() {
    StoreOpening opening;
    opening.full_check_size = 0;
    opening.progress = [this](const std::string& sentence) { said_ += sentence + '\n'; };
    return PlaceStore(path_, kDefaultCellSize, opening);
  }

  void readForMatching() {
    const PlaceStore store = openLarge();
    store.graph();
    store.forEachPlanes([](PlaceId, const CellPlanes&) {});
  }

  std::string said_;
};

TEST_F(LargeStoreTest, IsReadWithoutBeingChecked) {
  fill();
  EXPECT_NO_THROW(readForMatching());
  EXPECT_EQ(said_, "");
}

TEST_F(LargeStoreTest, FindsDamageInWhatIsRead) {
  for (const Damage& damage : kDamages) {
    const std::string name = damage.name;
    const bool in_what_matching_needs = name != "GridWithoutPlace" && name != "PlaceWithoutGrid" &&
                                        name != "ShortGrid" && name != "GridOfNull" &&
                                        name != "OtherCellSize";
    if (!in_what_matching_needs) continue;
    fs::remove(path_);
    fill();
    damage.inflict(path_);
    EXPECT_THROW(readForMatching(), StoreError) << name;
  }
}

TEST_F(LargeStoreTest, FindsDamageOfAGridWhenItIsAskedFor) {
  fill();
  runSql(path_, "UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2");
  EXPECT_NO_THROW(readForMatching());
  const PlaceStore store = openLarge();
  EXPECT_THROW(store.grid(2), StoreError);
  EXPECT_EQ(store.grid(3), makeGrid(3));
}

TEST_F(LargeStoreTest, RefusesAStoreOfOtherCells) {
  fill();
  runSql(path_, "UPDATE grid SET cell_size = 0.2");
  EXPECT_THROW(openLarge(), StoreError);
}

TEST_F(LargeStoreTest, IsCheckedInFullWhereItsLastUserDidNotEndWell) {
  fill();
  runSql(path_, "DELETE FROM place WHERE id = 2");  // leaves its grid: SQLite's default
  EXPECT_NO_THROW(openLarge());
  writeFile(path_ + "-journal", "");
  EXPECT_THROW(openLarge(), StoreError);
  EXPECT_NE(said_.find("checking"), std::string::npos) << said_;
}

/// While it lives files are reached as by a user who owns none of them; root may write everything.
class AsNobody {
 public:
  AsNobody() { EXPECT_EQ(seteuid(65534), 0); }
  ~AsNobody() { EXPECT_EQ(seteuid(0), 0); }
};

TEST_F(PlaceStoreTest, RefusesAFileThatCannotBeWritten) {
  fill();
  fs::permissions(path_, fs::perms(0444));
  fs::permissions(folder_.path(), fs::perms(0555));
  std::optional<AsNobody> nobody;
  if (geteuid() == 0) nobody.emplace();
  EXPECT_THROW(open(), StoreError);
  nobody.reset();
  fs::permissions(folder_.path(), fs::perms(0755));
}

TEST_F(PlaceStoreTest, AFileThatIsOnlyReadStaysAsItIs) {
  fill();
  const std::string before = readFile(path_);
  open().graph();
  EXPECT_EQ(readFile(path_), before);
}

TEST_F(PlaceStoreTest, RefusesAFolder) {
  EXPECT_THROW(PlaceStore(folder_.path().string(), kDefaultCellSize), StoreError);
}

TEST_F(PlaceStoreTest, RefusesAFileInAFolderThatIsNotThere) {
  EXPECT_THROW(PlaceStore(folder_.file("nowhere/places.db"), kDefaultCellSize), StoreError);
}

}  // namespace
}  // namespace place_memory::core
