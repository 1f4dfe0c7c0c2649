#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "core/store/full_disk.h"
#include "core/store/read_only.h"
#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

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

}  // namespace
}  // namespace place_memory::core
