#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "core/store/full_disk.h"
#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

TEST_F(PlaceStoreTest, KeepsOneFileOnly) {
  fill();
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_EQ(names, std::vector<std::string>{"places.db"});
}

TEST_F(PlaceStoreTest, OnAFullDiskItIsNotMadeAndLeavesNothing) {
  {
    const FullDisk full;
    EXPECT_THROW(open(), StoreError);
  }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(PlaceStoreTest, OfManyThatCreateItAtOnceOneHasIt) {
  for (int round = 0; round < 3; ++round) {
    const std::string path = folder_.file("places-" + std::to_string(round) + ".db");
    std::atomic<int> ready{0}, held{0};
    std::atomic<bool> all_tried{false};
    std::vector<std::thread> threads;
    threads.reserve(4);
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&, i] {
        for (++ready; ready < 4;) std::this_thread::yield();
        try {
          PlaceStore store(path, kDefaultCellSize);
          add(store, makePlace("of " + std::to_string(i)), makeGrid(1), kNoPlace);
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
    EXPECT_EQ(PlaceStore(path, kDefaultCellSize).map().size(), 1U);
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
  EXPECT_THROW(add(store, makePlace("d"), makeGrid(4), kNoPlace), StoreError);
  EXPECT_THROW(rename(store, 1, "e"), StoreError);
  EXPECT_EQ(store.map().size(), 3U);
}

TEST_F(PlaceStoreTest, RefusesChangesWhereAnotherFileStandsInThePlace) {
  fill();
  PlaceStore store = open();
  fs::rename(path_, folder_.file("elsewhere.db"));
  fill();
  EXPECT_THROW(commit(store, {PlaceRemoved{1}}), StoreError);
  EXPECT_EQ(open().map().size(), 3U);
}

TEST_F(PlaceStoreTest, AFileThatIsOnlyReadStaysAsItIs) {
  fill();
  const std::string before = readFile(path_);
  open().map();
  EXPECT_EQ(readFile(path_), before);
}

std::string reasonAgainst(const std::string& path) {
  try {
    PlaceStore(path, kDefaultCellSize);
  } catch (const StoreError& error) {
    return error.what();
  }
  return "";
}

TEST_F(PlaceStoreTest, RefusesAFolder) {
  EXPECT_NE(reasonAgainst(folder_.path().string()).find("is a folder"), std::string::npos);
}

TEST_F(PlaceStoreTest, RefusesWhatIsNoFileWithoutWaitingForIt) {
  const std::string pipe = folder_.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(reasonAgainst(pipe).find("is no file"), std::string::npos);
}

TEST_F(PlaceStoreTest, NamesTheFolderThatIsNotThere) {
  const std::string reason = reasonAgainst(folder_.file("nowhere/places.db"));
  EXPECT_NE(reason.find("no folder " + folder_.file("nowhere")), std::string::npos) << reason;
}

TEST_F(PlaceStoreTest, SaysWhereItLies) {
  const fs::path before = fs::current_path();
  const char* home = std::getenv("HOME");
  const std::string old_home = home == nullptr ? "" : home;
  fs::current_path(folder_.path());
  setenv("HOME", folder_.path().c_str(), 1);
  const std::string relative = PlaceStore("places.db", kDefaultCellSize).path();
  const std::string tilde = PlaceStore("~/places.db", kDefaultCellSize).path();
  fs::current_path(before);
  setenv("HOME", old_home.c_str(), 1);
  EXPECT_EQ(relative, fs::canonical(path_).string());
  EXPECT_EQ(tilde, fs::canonical(path_).string());
  EXPECT_EQ(PlaceStore("", kDefaultCellSize).path(), "");
}

TEST_F(PlaceStoreTest, FollowsALinkToItsFile) {
  fs::create_directory(folder_.file("disk"));
  fs::create_symlink(folder_.file("disk/real.db"), path_);
  fill();
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(PlaceStore(folder_.file("disk/real.db"), kDefaultCellSize).map().size(), 3U);
}

TEST_F(PlaceStoreTest, ClearsAwayWhatAKilledCreationLeft) {
  const std::string left = path_ + ".new-123-456";
  const std::string alone = path_ + ".new-7-8-journal";
  for (const std::string& name : {left, left + "-journal", alone}) writeFile(name, "half");
  const std::string other = path_ + ".new-years-party";
  writeFile(other, "of somebody");
  fill();
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::exists(left + "-journal"));
  EXPECT_FALSE(fs::exists(alone));
  EXPECT_TRUE(fs::exists(other));
}

}  // namespace
}  // namespace place_memory::core
