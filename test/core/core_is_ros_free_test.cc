// The core has to build where there is no ROS. This reads its sources: a header that happens to be
// installed beside ROS's would let a compiler accept what a machine without ROS does not.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = PLACE_MEMORY_SOURCE_DIR;

bool isAllowed(const std::string& header) {
  static const std::regex allowed(
      "(place_memory/)?core/[a-z0-9_/]+\\.h"  // itself
      "|support/[a-z0-9_]+\\.h"
      "|[a-z_]+"  // the standard library
      "|Eigen/.+|boost/.+|sqlite3\\.h"
      "|immintrin\\.h|arm_neon\\.h");  // of the compiler
  return std::regex_match(header, allowed);
}

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::vector<std::string> includesIn(const std::string& text) {
  static const std::regex include("#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
  std::vector<std::string> headers;
  for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
    headers.push_back((*match)[1]);
  }
  return headers;
}

std::vector<fs::path> sourcesOfTheCore() {
  std::vector<fs::path> files;
  for (const char* folder : {"include/place_memory/core", "src/core"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
    }
  }
  return files;
}

TEST(CoreIsRosFree, TheCheckKnowsRosWhenItSeesIt) {
  const std::string text =
      "#include <ros/ros.h>\n# include \"nav_msgs/OccupancyGrid.h\"\n"
      "#include \"place_memory/PlaceGraph.h\"\n#include \"place_memory/node/names.h\"\n";
  const auto headers = includesIn(text);
  ASSERT_EQ(headers.size(), 4U);
  for (const auto& header : headers) EXPECT_FALSE(isAllowed(header)) << header;
}

TEST(CoreIsRosFree, EveryIncludeIsTheCoresOwnOrANonRosLibrary) {
  const auto files = sourcesOfTheCore();
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    for (const auto& header : includesIn(contents(file))) {
      const bool is_neighbour = fs::exists(file.parent_path() / header);  // a private header
      EXPECT_TRUE(is_neighbour || isAllowed(header)) << file << " includes " << header;
    }
  }
}

TEST(CoreIsRosFree, NothingOfCatkinIsLinked) {
  const std::string text = contents(kRoot / "src/core/CMakeLists.txt");
  ASSERT_NE(text.find("place_memory_core"), std::string::npos);
  EXPECT_EQ(text.find("catkin_LIBRARIES"), std::string::npos);
  EXPECT_EQ(text.find("place_memory_ros"), std::string::npos);
}

}  // namespace
}  // namespace place_memory::core
