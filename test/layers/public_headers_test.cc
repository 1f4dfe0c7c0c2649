// What is installed is what other packages may rely on, so it stays small and complete in itself.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "layers/include_reader.h"
#include "layers/table.h"

namespace place_memory::layers {
namespace {

constexpr std::size_t kMostPublicHeaders = 25;

TEST(PublicHeaders, AreFew) {
  const std::size_t count = sourcesBelow("include").size();
  EXPECT_GT(count, 0U);
  EXPECT_LE(count, kMostPublicHeaders);
}

TEST(PublicHeaders, IncludeOnlyEachOtherAndTheStandardLibrary) {
  for (const std::string& file : sourcesBelow("include")) {
    for (const std::string& header : includesIn(contents(kRoot / file))) {
      const bool is_public = std::filesystem::exists(kRoot / "include" / header);
      EXPECT_TRUE(is_public || partOfHeader(header) == "std") << file << " includes " << header;
    }
  }
}

}  // namespace
}  // namespace place_memory::layers
