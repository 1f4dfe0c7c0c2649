#include "core/store/store_copy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

class StoreCopyTest : public PlaceStoreTest {
 protected:
  std::string problemOfSaving(const PlaceStore& store, const std::string& path) const {
    try {
      store.saveAs(path);
    } catch (const StoreError& error) {
      return error.what();
    }
    return "";
  }

  bool isSomethingLeft() const {
    const std::filesystem::directory_iterator files(folder_.path());
    return std::any_of(begin(files), end(files), [](const auto& file) {
      return file.path().string().find(".new-") != std::string::npos;
    });
  }

  const std::string copy_ = folder_.file("copy.db");
};

TEST_F(StoreCopyTest, IsAWholeStoreThoughTheOneItIsOfGoesOn) {
  fill();
  PlaceStore store = open();
  store.saveAs(copy_);
  commit(store, {PlaceRenamed{1, "changed"}});
  const PlaceStore copy(copy_, kDefaultCellSize);
  EXPECT_TRUE(copy.setAside().empty());
  EXPECT_EQ(copy.map().places().front().label, "a");
  EXPECT_EQ(copy.grid(3), makeGrid(3));
  EXPECT_EQ(store.map().places().front().label, "changed");
}

TEST_F(StoreCopyTest, OfAStoreInMemoryIsAFile) {
  PlaceStore store("", kDefaultCellSize);
  add(store, makePlace("a"), makeGrid(1), kNoPlace);
  store.saveAs(copy_);
  EXPECT_EQ(PlaceStore(copy_, kDefaultCellSize).map().size(), 1U);
}

TEST_F(StoreCopyTest, TakesThePlaceOfAnOlderStore) {
  fill();
  PlaceStore store = open();
  store.saveAs(copy_);
  commit(store, {PlaceRenamed{1, "changed"}});
  store.saveAs(copy_);
  EXPECT_EQ(PlaceStore(copy_, kDefaultCellSize).map().places().front().label, "changed");
  EXPECT_FALSE(isSomethingLeft());
}

TEST_F(StoreCopyTest, IsRefusedWhereItWouldDestroySomething) {
  fill();
  const PlaceStore store = open();
  EXPECT_NE(problemOfSaving(store, path_).find("the store itself"), std::string::npos);
  const std::string text = folder_.file("diary.txt");
  std::ofstream(text) << "dear diary";
  EXPECT_NE(problemOfSaving(store, text).find("no place store"), std::string::npos);
  EXPECT_EQ(std::filesystem::file_size(text), 10U);
  store.saveAs(copy_);
  const PlaceStore user(copy_, kDefaultCellSize);
  EXPECT_NE(problemOfSaving(store, copy_).find("in use"), std::string::npos);
  EXPECT_NE(problemOfSaving(store, folder_.file("none/copy.db")).find("no folder"),
            std::string::npos);
}

}  // namespace
}  // namespace place_memory::core
