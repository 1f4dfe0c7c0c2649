#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "core/store/full_disk.h"
#include "core/store/old_store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

void expectOldPlaces(const PlaceStore& store) {
  const PlaceMap map = store.map();
  ASSERT_EQ(map.size(), 3U);
  for (PlaceId id = 1; id <= 3; ++id) {
    const Place& place = map.places()[static_cast<std::size_t>(id - 1)];
    EXPECT_EQ(place.id, id);
    EXPECT_EQ(place.label, std::string(1, "abc"[id - 1]));
    EXPECT_EQ(place.map_from_place, (Pose2d{static_cast<double>(id) + 0.25, -7.5, 0.0}));
    EXPECT_EQ(place.learned.count(), 1000 + id);
    EXPECT_EQ(place.session, kFirstSession);
    EXPECT_NE(place.identity, PlaceIdentity{});
    EXPECT_EQ(store.grid(id), makeGrid(static_cast<unsigned>(id)));
    EXPECT_TRUE(store.readings(id).empty());
  }
  EXPECT_NE(map.places()[0].identity, map.places()[1].identity);
  EXPECT_EQ(map.links().size(), 2U);
  EXPECT_EQ(map.findLink(1, 2)->first_from_second, (Pose2d{1.0, 0.0, 0.0}));
  EXPECT_EQ(map.stamp().count(), 1003);
  std::size_t planes = 0;
  store.forEachPlanes([&](PlaceId id, const CellPlanes& found) {
    EXPECT_EQ(found.occupied, CellPlanes(makeGrid(static_cast<unsigned>(id))).occupied);
    ++planes;
  });
  EXPECT_EQ(planes, 3U);
  EXPECT_EQ(store.nextId(), 5);  // 4 was given to a place that is gone
  EXPECT_TRUE(store.setAside().empty());
}

class StoreMigrationTest : public PlaceStoreTest, public testing::WithParamInterface<int> {
 protected:
  std::string keptName() const { return path_ + ".format-" + std::to_string(GetParam()); }

  PlaceStore openAndListen() {
    StoreOpening opening;
    opening.progress = [this](const std::string& sentence) { said_ += sentence + '\n'; };
    return PlaceStore(path_, kDefaultCellSize, opening);
  }

  // Leaves what power leaves that fails while `sql` changes the store: some pages are written, and
  // the journal by which they are put back.
  void cutOff(const std::string& sql) const {
    const pid_t child = fork();
    if (child == 0) {
      sqlite3* database = nullptr;
      sqlite3_open(path_.c_str(), &database);
      sqlite3_exec(database, "PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN IMMEDIATE",
                   nullptr, nullptr, nullptr);
      sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
      sqlite3_db_cacheflush(database);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_GT(fs::file_size(path_ + "-journal"), 512U);
  }

  std::string said_;
};

TEST_P(StoreMigrationTest, BringsTheStoreToTheNewFormatAndKeepsTheOldFile) {
  makeOldStore(path_, GetParam());
  const std::string before = readFile(path_);
  expectOldPlaces(openAndListen());
  EXPECT_EQ(readFile(keptName()), before);
  EXPECT_NE(said_.find("kept as " + keptName()), std::string::npos) << said_;
  said_.clear();
  expectOldPlaces(openAndListen());
  EXPECT_EQ(said_, "");
  PlaceStore store = open();
  EXPECT_EQ(add(store, makePlace("e"), makeGrid(5), 3), 5);
  EXPECT_EQ(readFile(keptName()), before);
}

TEST_P(StoreMigrationTest, NeverWritesOverAFileThatIsKept) {
  writeFile(keptName(), "from before");
  makeOldStore(path_, GetParam());
  const std::string before = readFile(path_);
  expectOldPlaces(openAndListen());
  EXPECT_EQ(readFile(keptName()), "from before");
  EXPECT_EQ(readFile(keptName() + "-2"), before);
}

TEST_P(StoreMigrationTest, GivesTwoCopiesOfAStoreTheSameIdentities) {
  makeOldStore(path_, GetParam());
  const std::string copy = folder_.file("copy.db");
  fs::copy_file(path_, copy);
  const PlaceStore one = open();
  const PlaceStore other(copy, kDefaultCellSize);
  EXPECT_EQ(one.identity(), other.identity());
  EXPECT_EQ(one.map().places(), other.map().places());
}

TEST_P(StoreMigrationTest, UndoesAChangeThatWasCutOffBeforeItLooksAtTheFormat) {
  makeOldStore(path_, GetParam());
  cutOff("UPDATE place SET label = 'x' || label; DELETE FROM link; PRAGMA user_version = 9;");
  expectOldPlaces(openAndListen());
  EXPECT_FALSE(fs::exists(path_ + "-journal"));
}

TEST_P(StoreMigrationTest, IsReadFromAFullDiskAndMigratedLater) {
  makeOldStore(path_, GetParam());
  const std::string before = readFile(path_);
  std::unique_ptr<PlaceStore> store;
  {
    const FullDisk full;
    store = std::make_unique<PlaceStore>(path_, kDefaultCellSize);
    expectOldPlaces(*store);
    EXPECT_NE(store->whyReadOnly(), "");
    EXPECT_THROW(rename(*store, 1, "z"), StoreError);
    expectOldPlaces(*store);
    EXPECT_THROW(open(), StoreError);  // the file is locked
  }
  EXPECT_EQ(readFile(path_), before);
  rename(*store, 1, "z");
  EXPECT_EQ(store->whyReadOnly(), "");
  store.reset();
  EXPECT_EQ(open().map().find(1)->label, "z");
  EXPECT_EQ(readFile(keptName()), before);
}

TEST_P(StoreMigrationTest, CutOffAnywhereItLeavesTheOldStoreOrTheNewOne) {
  using Clock = std::chrono::steady_clock;
  makeOldStore(path_, GetParam());
  const Clock::time_point begin = Clock::now();
  open();
  const Clock::duration whole = Clock::now() - begin;
  constexpr int kKills = 16;
  for (int i = 0; i < kKills; ++i) {
    for (const auto& entry : fs::directory_iterator(folder_.path())) fs::remove(entry.path());
    makeOldStore(path_, GetParam());
    const pid_t child = fork();
    if (child == 0) {
      open();
      _exit(0);
    }
    std::this_thread::sleep_for(whole * i / kKills);
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    expectOldPlaces(open());
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_EQ(entry.path().string().find(".new-"), std::string::npos) << entry.path();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, StoreMigrationTest, testing::Values(1, 2));

class HotJournalTest : public StoreMigrationTest {};

// As when a version that knew format 2 was cut off bringing a store of format 1 to it.
TEST_P(HotJournalTest, OfAMigrationToFormat2LeavesAStoreOfFormat1) {
  makeOldStore(path_, 1);
  cutOff(kToFormat2);
  expectOldPlaces(openAndListen());
  EXPECT_NE(said_.find("from format 1 to 5"), std::string::npos) << said_;
}

TEST_P(HotJournalTest, OfAChangeInTheNewestFormatIsUndone) {
  fill();
  cutOff("DELETE FROM place; DELETE FROM grid; DELETE FROM planes; PRAGMA user_version = 2;");
  const PlaceStore store = open();
  EXPECT_EQ(store.map().size(), 3U);
  EXPECT_EQ(store.grid(2), makeGrid(2));
  EXPECT_TRUE(store.setAside().empty());
}

INSTANTIATE_TEST_SUITE_P(Once, HotJournalTest, testing::Values(1));

}  // namespace
}  // namespace place_memory::core
