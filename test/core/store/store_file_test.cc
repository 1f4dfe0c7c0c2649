#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
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

/// While it lives files are reached as by a user who owns none of them; root may write everything.
class AsNobody {
 public:
  AsNobody() { EXPECT_EQ(seteuid(65534), 0); }
  ~AsNobody() { EXPECT_EQ(seteuid(0), 0); }
};

/// While it lives the file, and where it lies, may be read and not written.
class ReadOnly {
 public:
  explicit ReadOnly(const fs::path& file) : file_(file) {
    fs::permissions(file_, fs::perms(0444));
    fs::permissions(file_.parent_path(), fs::perms(0555));
    if (geteuid() == 0) nobody_.emplace();
  }
  ~ReadOnly() {
    nobody_.reset();
    fs::permissions(file_.parent_path(), fs::perms(0777));
    fs::permissions(file_, fs::perms(0666));
  }
  ReadOnly(const ReadOnly&) = delete;
  ReadOnly& operator=(const ReadOnly&) = delete;

 private:
  const fs::path file_;
  std::optional<AsNobody> nobody_;
};

void expectThreePlaces(const PlaceStore& store) {
  const PlaceMap map = store.map();
  EXPECT_EQ(map.size(), 3U);
  EXPECT_EQ(map.links().size(), 2U);
  std::size_t planes = 0;
  store.forEachPlanes([&planes](PlaceId, const CellPlanes&) { ++planes; });
  EXPECT_EQ(planes, 3U);
  EXPECT_EQ(store.grid(2), makeGrid(2));
}

TEST_F(PlaceStoreTest, ReadsAFileThatCannotBeWrittenUntilItCan) {
  fill();
  std::optional<PlaceStore> store;
  {
    const ReadOnly read_only(path_);
    store.emplace(open());
    expectThreePlaces(*store);
    EXPECT_NE(store->whyReadOnly().find(path_), std::string::npos);
    EXPECT_THROW(rename(*store, 1, "z"), StoreError);
    expectThreePlaces(*store);
  }
  // Somebody else may write the file again; this one may too, but for the test's being root.
  rename(*store, 1, "z");
  EXPECT_EQ(store->whyReadOnly(), "");
  store.reset();
  EXPECT_EQ(open().map().find(1)->label, "z");
}

TEST_F(PlaceStoreTest, DoesNotWriteOverWhatAnotherProgramWroteMeanwhile) {
  fill();
  std::optional<PlaceStore> store;
  {
    const ReadOnly read_only(path_);
    store.emplace(open());
  }
  const std::string copy = folder_.file("copy.db");
  fs::copy_file(path_, copy);
  {
    PlaceStore other(copy, kDefaultCellSize);
    rename(other, 1, "theirs");
  }
  fs::rename(copy, path_);
  EXPECT_THROW(rename(*store, 2, "mine"), StoreError);
  EXPECT_THROW(rename(*store, 2, "mine"), StoreError);
  EXPECT_NE(store->whyReadOnly().find("another program"), std::string::npos);
  store.reset();
  EXPECT_EQ(open().map().find(1)->label, "theirs");
  EXPECT_EQ(open().map().find(2)->label, "b");
}

TEST_F(PlaceStoreTest, SaysSoWhereItCannotBeOpenedAnewForWriting) {
  fill();
  std::optional<PlaceStore> store;
  {
    const ReadOnly read_only(path_);
    store.emplace(open());
  }
  const std::string good = readFile(path_);
  fs::remove(path_);
  writeFile(path_, "something else");
  EXPECT_THROW(rename(*store, 1, "z"), StoreError);
  EXPECT_THROW(store->grid(1), StoreError);
  EXPECT_EQ(readFile(path_), "something else");
  writeFile(path_, good);
  rename(*store, 1, "z");
  expectThreePlaces(*store);
}

TEST_F(PlaceStoreTest, OnAFullDiskItIsReadAndWritingResumes) {
  fill();
  std::optional<PlaceStore> store;
  {
    const FullDisk full;
    store.emplace(open());
    expectThreePlaces(*store);
    EXPECT_NE(store->whyReadOnly(), "");
    EXPECT_THROW(add(*store, makePlace("d"), makeGrid(4), 1), StoreError);
    expectThreePlaces(*store);
  }
  EXPECT_EQ(add(*store, makePlace("d"), makeGrid(4), 1), 4);
  EXPECT_EQ(store->whyReadOnly(), "");
  EXPECT_EQ(store->grid(4), makeGrid(4));
  store.reset();
  EXPECT_EQ(open().map().size(), 4U);
}

TEST_F(PlaceStoreTest, OutlivesADiskThatFillsUpWhileItIsOpen) {
  fill();
  PlaceStore store = open();
  rename(store, 1, "before");
  {
    const FullDisk full;
    EXPECT_THROW(add(store, makePlace("d"), makeGrid(4), 1), StoreError);
    EXPECT_NE(store.whyReadOnly(), "");
    expectThreePlaces(store);
  }
  EXPECT_EQ(add(store, makePlace("d"), makeGrid(4), 1), 4);
  EXPECT_EQ(store.whyReadOnly(), "");
  EXPECT_EQ(store.map().find(1)->label, "before");
  EXPECT_THROW(rename(store, 2, "d"), StoreError);
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
  for (const std::string& name : {left, left + "-journal"}) writeFile(name, "half");
  const std::string other = path_ + ".new-years-party";
  writeFile(other, "of somebody");
  fill();
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::exists(left + "-journal"));
  EXPECT_TRUE(fs::exists(other));
}

}  // namespace
}  // namespace place_memory::core
