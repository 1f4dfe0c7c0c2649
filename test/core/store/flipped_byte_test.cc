#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPageSize = 4096;

/// Every byte in turn says something else than what was written.
///
/// With PLACE_MEMORY_EVERY_BYTE set it is every byte; otherwise every one of the pages that hold
/// places, links and what the store says of itself, and some of the others.
class FlippedByteTest : public PlaceStoreTest {
 protected:
  struct Served {
    std::map<PlaceId, Place> places;
    std::vector<PlaceLink> links;
    std::map<PlaceId, EvidenceGrid> grids;
    std::map<PlaceId, CellPlanes> planes;
    PlaceId next_id = 0;
    bool is_named = false;
  };

  static Served read(const PlaceStore& store) {
    Served served;
    const PlaceMap map = store.map();
    for (const Place& place : map.places()) served.places[place.id] = place;
    served.links = map.links();
    store.forEachGrid([&](PlaceId id, const EvidenceGrid& grid) { served.grids[id] = grid; });
    store.forEachPlanes([&](PlaceId id, const CellPlanes& planes) { served.planes[id] = planes; });
    served.next_id = store.nextId();
    served.is_named = !store.setAside().empty();
    return served;
  }

  // Nothing else is served than what was written.
  bool isRight(const Served& served) const {
    for (const auto& [id, place] : served.places) {
      if (whole_.places.count(id) == 0 || !(whole_.places.at(id) == place)) return false;
    }
    for (const auto& [id, grid] : served.grids) {
      if (whole_.grids.count(id) == 0 || !(whole_.grids.at(id) == grid)) return false;
    }
    for (const auto& [id, planes] : served.planes) {
      if (whole_.planes.count(id) == 0) return false;
      const CellPlanes& expected = whole_.planes.at(id);
      if (planes.occupied != expected.occupied || planes.empty != expected.empty) return false;
    }
    for (const PlaceLink& link : served.links) {
      if (!(makeLink(link.first, link.second) == link)) return false;
    }
    return served.next_id >= whole_.next_id;
  }

  bool isWhole(const Served& served) const {
    return isRight(served) && served.places.size() == whole_.places.size() &&
           served.links.size() == whole_.links.size() &&
           served.grids.size() == whole_.grids.size() &&
           served.planes.size() == whole_.planes.size();
  }

  void write(std::size_t offset, char byte) const {
    const int file = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_EQ(pwrite(file, &byte, 1, static_cast<off_t>(offset)), 1);
    close(file);
  }

  // A page of a table's rows that is not most of all cells.
  static bool isOfSmallRows(const std::string& bytes, std::size_t page) {
    const std::string content = bytes.substr(page * kPageSize, kPageSize);
    if (page == 0) return true;
    const bool is_leaf = content[0] == '\x0d';
    const std::size_t cells = static_cast<unsigned char>(content[4]);
    return is_leaf && cells > 0 && content.find("abcdefghij") != std::string::npos;
  }

  Served whole_;
};

TEST_F(FlippedByteTest, IsNeverServedWithoutAWord) {
  {
    PlaceStore store = open();
    // The word is what the pages of places are known by.
    add(store, makePlace("abcdefghij"), makeGrid(1), kNoPlace);
    add(store, makePlace("abcdefghij 2"), makeGrid(2), 1);
    add(store, makePlace("c"), makeGrid(3), 2);
  }
  whole_ = read(open());
  ASSERT_EQ(whole_.planes.size(), 3U);
  ASSERT_FALSE(whole_.is_named);
  const std::string bytes = readFile(path_);
  const bool every_byte = std::getenv("PLACE_MEMORY_EVERY_BYTE") != nullptr;
  std::map<std::string, int> counts;
  for (std::size_t offset = 0; offset < bytes.size(); ++offset) {
    const bool is_of_small_rows = isOfSmallRows(bytes, offset / kPageSize);
    if (!every_byte && offset % (is_of_small_rows ? 5 : 61) != 0) continue;
    const auto bit = static_cast<unsigned>(offset / 5 % 8);
    write(offset, static_cast<char>(static_cast<unsigned char>(bytes[offset]) ^ 1U << bit));
    try {
      const Served served = read(open());
      if (!isRight(served)) {
        ++counts["wrong"];
        ADD_FAILURE() << "wrong with byte " << offset << ", bit " << bit;
      } else if (served.is_named) {
        ++counts["named"];
      } else if (isWhole(served)) {
        ++counts["of no effect"];
      } else {
        ++counts["missing without a word"];
        ADD_FAILURE() << "something is missing with byte " << offset << ", bit " << bit;
      }
    } catch (const StoreError&) {
      ++counts["refused"];
    }
    write(offset, bytes[offset]);
  }
  for (const auto& [what, count] : counts) RecordProperty(what, count);
  for (const auto& [what, count] : counts) std::printf("%s: %d\n", what.c_str(), count);
  EXPECT_EQ(readFile(path_), bytes);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(FlippedByteTest, IsMadeNoWorseByAChange) {
  {
    PlaceStore store = open();
    add(store, makePlace("a"), makeGrid(1), kNoPlace);
    add(store, makePlace("b"), makeGrid(2), 1);
    add(store, makePlace("c"), makeGrid(3), 2);
  }
  whole_ = read(open());
  const std::string bytes = readFile(path_);
  int edited = 0;
  for (std::size_t offset = 0; offset < bytes.size(); offset += 397) {
    writeFile(path_, bytes);
    write(offset, static_cast<char>(static_cast<unsigned char>(bytes[offset]) ^ 0x10U));
    Served before;
    try {
      PlaceStore store = open();
      before = read(store);
      const PlaceId id = add(store, makePlace("d"), makeGrid(4), kNoPlace);
      commit(store, {PlaceRemoved{id}});
      ++edited;
    } catch (const StoreError&) {
      continue;
    }
    const Served after = read(open());
    EXPECT_TRUE(isRight(after)) << offset;
    EXPECT_GE(after.places.size(), before.places.size()) << offset;
    EXPECT_GE(after.links.size(), before.links.size()) << offset;
    EXPECT_GE(after.grids.size(), before.grids.size()) << offset;
    EXPECT_GE(after.planes.size(), before.planes.size()) << offset;
  }
  EXPECT_GT(edited, 50);
}

}  // namespace
}  // namespace place_memory::core
