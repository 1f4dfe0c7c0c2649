// What was found by scripts/fuzz once, and must not be found again: each file of the corpus.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/temporary_folder.h"
#include "fuzz/targets.h"

namespace place_memory::fuzz {
namespace {

namespace fs = std::filesystem;

class CorpusTest : public testing::TestWithParam<Target> {};

TEST_P(CorpusTest, IsTakenOrRefused) {
  const fs::path folder = fs::path(PLACE_MEMORY_SOURCE_DIR) / "test/fuzz/corpus" / GetParam().name;
  ASSERT_TRUE(fs::is_directory(folder)) << folder;
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string bytes = readFile(entry.path().string());
    GetParam().run(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++files;
  }
  EXPECT_GT(files, 0);
}

INSTANTIATE_TEST_SUITE_P(Targets, CorpusTest, testing::ValuesIn(targets()),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace place_memory::fuzz
