#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/store/served_store.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

/// Every byte in turn says something else than what was written.
///
/// With PLACE_MEMORY_EVERY_BYTE set, as scripts/corrupt_test has it, it is every byte, and each in
/// two ways; otherwise some of the pages that hold places, links and what the store says of itself,
/// and fewer of the others.
class FlippedByteTest : public ServedStoreTest {
 protected:
  // A page of a table's rows that is not most of all cells.
  static bool isOfSmallRows(const std::string& bytes, std::size_t page) {
    const std::string content = bytes.substr(page * kPageSize, kPageSize);
    if (page == 0) return true;
    const bool is_leaf = content[0] == '\x0d';
    const std::size_t cells = static_cast<unsigned char>(content[4]);
    return is_leaf && cells > 0 && content.find("abcdefghij") != std::string::npos;
  }

  void flip(const std::string& bytes, std::size_t offset, unsigned mask,
            const std::vector<Served>& wholes) {
    const auto flipped = static_cast<char>(static_cast<unsigned char>(bytes[offset]) ^ mask);
    write(offset, std::string(1, flipped));
    count(outcome(wholes), "byte " + std::to_string(offset) + " with " + std::to_string(mask));
    write(offset, bytes.substr(offset, 1));
  }
};

TEST_F(FlippedByteTest, IsNeverServedWithoutAWord) {
  const std::vector<Served> wholes{read()};
  ASSERT_EQ(wholes[0].planes.size(), 3U);
  ASSERT_EQ(wholes[0].nodes.size(), 4U);
  ASSERT_FALSE(wholes[0].is_named);
  const std::string bytes = readFile(path_);
  for (std::size_t offset = 0; offset < bytes.size(); ++offset) {
    const bool is_of_small_rows = isOfSmallRows(bytes, offset / kPageSize);
    if (!everyByte() && offset % (is_of_small_rows ? 11 : 157) != 0) continue;
    flip(bytes, offset, 1U << offset / 5 % 8, wholes);
    if (everyByte()) flip(bytes, offset, 0xffU, wholes);
  }
  EXPECT_EQ(readFile(path_), bytes);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(FlippedByteTest, IsMadeNoWorseByAChange) {
  const std::vector<Served> wholes{read()};
  const std::string bytes = readFile(path_);
  int edited = 0;
  for (std::size_t offset = 0; offset < bytes.size(); offset += everyByte() ? 23 : 1201) {
    writeFile(path_, bytes);
    write(offset,
          std::string(1, static_cast<char>(static_cast<unsigned char>(bytes[offset]) ^ 16U)));
    try {
      PlaceStore store = open();
      const Served before(store);
      const PlaceId id = add(store, makePlace("d"), makeGrid(4), kNoPlace);
      commit(store, {PlaceRemoved{id}});
      store = PlaceStore("", kDefaultCellSize);
      ++edited;
      const Served after = read();
      EXPECT_TRUE(isOf(after, wholes)) << offset;
      EXPECT_TRUE(isOf(before, {after})) << offset;
    } catch (const StoreError&) {
      continue;
    }
  }
  EXPECT_GT(edited, 30);
}

}  // namespace
}  // namespace place_memory::core
