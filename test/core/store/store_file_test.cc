#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <vector>

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

/// While it lives no file grows, as with a full disk.
class FullDisk {
 public:
  FullDisk() {
    signal(SIGXFSZ, SIG_IGN);
    EXPECT_EQ(getrlimit(RLIMIT_FSIZE, &before_), 0);
    const rlimit none{0, before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
  }
  ~FullDisk() {
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before_), 0);
    signal(SIGXFSZ, SIG_DFL);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

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
  EXPECT_THROW(store.add(makePlace("d"), makeGrid(4), kNoPlace), StoreError);
  EXPECT_THROW(store.rename(1, "e"), StoreError);
  EXPECT_EQ(store.map().size(), 3U);
}

TEST_F(PlaceStoreTest, RefusesChangesWhereAnotherFileStandsInThePlace) {
  fill();
  PlaceStore store = open();
  fs::rename(path_, folder_.file("elsewhere.db"));
  fill();
  EXPECT_THROW(store.remove(1), StoreError);
  EXPECT_EQ(open().map().size(), 3U);
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
  open().map();
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
