#include "layers/include_reader.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace place_memory::layers {

namespace fs = std::filesystem;

const fs::path kRoot = PLACE_MEMORY_SOURCE_DIR;

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

std::vector<std::string> sourcesBelow(const std::string& folder) {
  std::vector<std::string> files;
  if (!fs::exists(kRoot / folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const fs::path extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    files.push_back(entry.path().lexically_relative(kRoot).generic_string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace place_memory::layers
