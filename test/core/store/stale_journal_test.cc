#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/store/full_disk.h"
#include "core/store/read_only.h"
#include "core/store/store_fixture.h"
#include "core/store/unfinished_change.h"

// A journal that is left by a change that was cut off, beside the store that it is of or not.
namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

constexpr char kChange[] =
    "UPDATE store SET map_version = map_version + 1; UPDATE place SET label = 'x' || label; "
    "DELETE FROM grid; DELETE FROM planes;";

class StaleJournalTest : public PlaceStoreTest {
 protected:
  std::string journal() const { return path_ + "-journal"; }

  // Each change is of a version of its own, as the memory has it.
  void renameFirst(const std::string& label, std::uint64_t version) const {
    PlaceStore store = open();
    MapChange change;
    change.version = version;
    change.edits = {PlaceRenamed{1, label}};
    store.commit(change);
  }

  void expectRefusedUntouched() const {
    const std::string file = readFile(path_);
    const std::string other = readFile(journal());
    try {
      open();
      FAIL() << "the store was taken";
    } catch (const StoreError& error) {
      EXPECT_NE(std::string(error.what()).find("move that journal away"), std::string::npos)
          << error.what();
    }
    EXPECT_EQ(readFile(path_), file);
    EXPECT_EQ(readFile(journal()), other);
  }

  static void expectThreePlaces(const PlaceStore& store) {
    EXPECT_EQ(store.map().size(), 3U);
    EXPECT_EQ(store.map().find(1)->label, "a");
    EXPECT_EQ(store.grid(2), makeGrid(2));
    EXPECT_TRUE(store.setAside().empty());
  }
};

TEST_F(StaleJournalTest, UndoesTheChangeOfItsOwnStore) {
  fill();
  leaveUnfinished(path_, kChange);
  expectThreePlaces(open());
  EXPECT_FALSE(fs::exists(journal()));
}

TEST_F(StaleJournalTest, SparesABackupOfTheSameStoreFromBefore) {
  fill();
  const std::string backup = readFile(path_);
  renameFirst("newer", 2);
  leaveUnfinished(path_, kChange);
  writeFile(path_, backup);
  expectRefusedUntouched();
  // What is said to be done helps.
  fs::rename(journal(), folder_.file("away"));
  expectThreePlaces(open());
}

TEST_F(StaleJournalTest, SparesABackupOfTheSameStoreFromAfter) {
  fill();
  const std::string before = readFile(path_);
  for (std::uint64_t version = 2; version < 5; ++version) {
    renameFirst("later " + std::to_string(version), version);
  }
  const std::string backup = readFile(path_);
  writeFile(path_, before);
  leaveUnfinished(path_, kChange);
  writeFile(path_, backup);
  expectRefusedUntouched();
}

TEST_F(StaleJournalTest, SparesAnotherStore) {
  fill();
  const std::string other = readFile(path_);
  fs::remove(path_);
  fill();
  leaveUnfinished(path_, kChange);
  writeFile(path_, other);
  expectRefusedUntouched();
}

TEST_F(StaleJournalTest, OfAChangeThatWroteNothingYetSparesAnotherStoreToo) {
  fill();
  leaveUnfinished(path_, kChange);
  std::string begun = readFile(journal());
  for (std::size_t at = 8; at < 12; ++at) begun[at] = '\0';  // its number of pages
  fs::remove(journal());
  fs::remove(path_);
  fill();
  {
    PlaceStore store = open();
    for (int i = 0; i < 8; ++i) {
      add(store, makePlace("more " + std::to_string(i)), makeGrid(9), kNoPlace);
    }
  }
  writeFile(journal(), begun);
  expectRefusedUntouched();
}

TEST_F(StaleJournalTest, ThatHasEndedIsNone) {
  fill();
  writeFile(journal(), std::string(4096, '\0'));
  expectThreePlaces(open());
  writeFile(journal(), "");
  expectThreePlaces(open());
}

TEST_F(StaleJournalTest, OnAReadOnlyDiskTheStoreServesAsItWas) {
  fill();
  leaveUnfinished(path_, kChange);
  const std::string file = readFile(path_);
  const std::string change = readFile(journal());
  std::optional<PlaceStore> store;
  {
    const ReadOnly read_only(path_);
    store.emplace(open());
    expectThreePlaces(*store);
    EXPECT_NE(store->whyReadOnly(), "");
    EXPECT_THROW(rename(*store, 1, "z"), StoreError);
    expectThreePlaces(*store);
  }
  EXPECT_EQ(readFile(path_), file);
  EXPECT_EQ(readFile(journal()), change);
  rename(*store, 2, "z");
  EXPECT_EQ(store->whyReadOnly(), "");
  store.reset();
  EXPECT_EQ(open().map().find(2)->label, "z");
  EXPECT_EQ(open().grid(2), makeGrid(2));
}

TEST_F(StaleJournalTest, OnADiskThatHasNoRoomForACopyEitherTheReasonIsSaid) {
  fill();
  leaveUnfinished(path_, kChange);
  const std::string change = readFile(journal());
  {
    const FullDisk full;  // in which nothing at all can be written
    EXPECT_THROW(open(), StoreError);
  }
  EXPECT_EQ(readFile(journal()), change);
  expectThreePlaces(open());
}

}  // namespace
}  // namespace place_memory::core
