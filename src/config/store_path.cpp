#include "config/store_path.h"

#include <cstdlib>
#include <filesystem>

#include "support/text.h"

namespace place_memory::config {
namespace {

bool isInHome(const std::string& path) { return path == "~" || path.rfind("~/", 0) == 0; }

std::string home() {
  const char* folder = std::getenv("HOME");
  return folder == nullptr ? "" : folder;
}

}  // namespace

std::string checkStorePath(const std::string& path) {
  if (support::hasControls(path)) return "must be a path without control characters";
  if (!path.empty() && support::trimmed(path).empty()) return "must not be blank";
  if (path.empty() || path.front() != '~') return {};
  if (!isInHome(path)) return "must name the home folder of another user in full";
  if (path.size() < 3) return "must be a file, and is a folder";
  return home().empty() ? "must be a whole path, since HOME is not set" : "";
}

std::string absoluteStorePath(const std::string& path) {
  if (path.empty()) return {};
  const std::filesystem::path whole = isInHome(path) ? home() + path.substr(1) : path;
  return std::filesystem::absolute(whole).lexically_normal().string();
}

}  // namespace place_memory::config
