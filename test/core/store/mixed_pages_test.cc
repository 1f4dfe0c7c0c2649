#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/store/served_store.h"

namespace place_memory::core {
namespace {

/// Pages of the file stand where others should, or are gone. scripts/corrupt_test does more of it.
class MixedPagesTest : public ServedStoreTest {
 protected:
  std::string page(const std::string& bytes, std::size_t number) const {
    return bytes.substr(number * kPageSize, kPageSize);
  }

  void examine(const std::string& bytes, const std::vector<Served>& wholes,
               const std::string& what) {
    writeFile(path_, bytes);
    count(outcome(wholes), what);
  }

  // Of so many variants the short form takes one in `share`.
  bool isWanted(std::size_t variant, std::size_t share) const {
    return everyByte() || variant % share == 0;
  }
};

TEST_F(MixedPagesTest, ATruncatedStoreIsNeverServedWithoutAWord) {
  const std::vector<Served> wholes{read()};
  const std::string bytes = readFile(path_);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    if (size % kPageSize != 0 && !isWanted(size, 3001)) continue;
    if (everyByte() && size % 13 != 0) continue;
    examine(bytes.substr(0, size), wholes, "cut to " + std::to_string(size));
  }
}

TEST_F(MixedPagesTest, PagesThatTookTheOthersPlaceAreNeverServedWithoutAWord) {
  const std::vector<Served> wholes{read()};
  const std::string bytes = readFile(path_);
  const std::size_t pages = bytes.size() / kPageSize;
  std::size_t variant = 0;
  for (std::size_t one = 0; one < pages; ++one) {
    for (std::size_t other = one + 1; other < pages; ++other) {
      if (!isWanted(++variant, 7)) continue;
      std::string swapped = bytes;
      swapped.replace(one * kPageSize, kPageSize, page(bytes, other));
      const std::string doubled = swapped;
      swapped.replace(other * kPageSize, kPageSize, page(bytes, one));
      const std::string what = std::to_string(one) + " and " + std::to_string(other);
      examine(swapped, wholes, "swapped " + what);
      examine(doubled, wholes, "doubled " + what);
    }
  }
}

TEST_F(MixedPagesTest, PagesWithoutSenseAreNeverServedWithoutAWord) {
  const std::vector<Served> wholes{read()};
  const std::string bytes = readFile(path_);
  std::mt19937 random(7);
  std::string noise(kPageSize, ' ');
  for (char& byte : noise) byte = static_cast<char>(random());
  for (const std::string& nonsense :
       {std::string(kPageSize, '\0'), std::string(kPageSize, '\xff'), noise}) {
    for (std::size_t at = 0; at < bytes.size(); at += kPageSize) {
      std::string broken = bytes;
      broken.replace(at, kPageSize, nonsense);
      examine(broken, wholes, "page " + std::to_string(at / kPageSize) + " without sense");
    }
  }
}

// As where a disk loses a write, or a file is copied while it is written.
TEST_F(MixedPagesTest, PagesOfAnotherTimeAreNeverServedWithoutAWord) {
  std::vector<Served> wholes{read()};
  const std::string old = readFile(path_);
  {
    PlaceStore store = open();
    MapChange change;
    change.version = 3;
    change.edits = {PlaceRenamed{1, "renamed"}, addition(4, makePlace("d"), makeGrid(4)),
                    LinkAdded{makeLink(3, 4)},
                    GridAdapted{2, std::make_shared<EvidenceGrid>(makeGrid(5))}};
    KeptMap scans = makeScans();
    scans.nodes[2].pose.x += 1.0;
    store.commit(change, scans);
  }
  wholes.push_back(read());
  const std::string now = readFile(path_);
  std::vector<std::size_t> changed;
  for (std::size_t at = 0; at < std::min(old.size(), now.size()); at += kPageSize) {
    if (old.compare(at, kPageSize, now, at, kPageSize) != 0) changed.push_back(at);
  }
  ASSERT_GT(changed.size(), 4U);
  std::mt19937 random(3);
  const std::size_t mixtures = everyByte() ? 3000 : 150;
  for (std::size_t mixture = 0; mixture < changed.size() + mixtures; ++mixture) {
    std::string mixed = now;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      const bool is_old = mixture < changed.size() ? i == mixture : random() % 2 == 0;
      if (is_old) mixed.replace(changed[i], kPageSize, old, changed[i], kPageSize);
    }
    examine(mixed, wholes, "mixture " + std::to_string(mixture));
  }
}

}  // namespace
}  // namespace place_memory::core
