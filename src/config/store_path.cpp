#include "config/store_path.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "support/text.h"

namespace place_memory::config {
namespace {

bool isInHome(const std::string& path) { return path == "~" || path.rfind("~/", 0) == 0; }

std::string home() {
  const char* folder = std::getenv("HOME");
  return folder == nullptr ? "" : folder;
}

constexpr std::size_t kMostNameBytes = 1000;

// Which SQLite has beside a store; the rest of a name is of no matter.
bool isPartOfStore(const std::string& name) {
  for (const std::string_view ending : {"-journal", "-wal", "-shm"}) {
    if (name.size() >= ending.size() && name.substr(name.size() - ending.size()) == ending) {
      return true;
    }
  }
  return false;
}

[[noreturn]] void refuseName(const std::string& name, const std::string& why) {
  throw std::runtime_error("the name \"" + support::printable(name.substr(0, kMostNameBytes)) +
                           "\" of a store " + why);
}

}  // namespace

std::string pathInStoreDirectory(const std::string& directory, const std::string& name) {
  namespace fs = std::filesystem;
  if (support::trimmed(name).empty()) refuseName(name, "must not be blank");
  if (name.size() > kMostNameBytes) refuseName(name, "is too long");
  if (support::hasControls(name)) refuseName(name, "must not hold control characters");
  if (name.front() == '~') refuseName(name, "must not begin with a tilde");
  if (isPartOfStore(name)) refuseName(name, "is that of a part of another one");
  std::error_code error;
  const fs::path folder = fs::canonical(directory, error);
  if (error) throw std::runtime_error("there is no folder " + directory + " of stores");
  const fs::path wanted = folder / name;  // a whole path stays one
  const fs::path whole = fs::weakly_canonical(wanted, error);
  const auto [end, at] = std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end());
  const bool is_below = !error && end == folder.end() && at != whole.end();
  // A link to what is not there is not resolved, and would be followed by who makes the file.
  const bool leads_nowhere = fs::is_symlink(wanted, error) && !fs::exists(wanted, error);
  if (!is_below || leads_nowhere || whole.filename().empty()) {
    refuseName(name, "must be that of a file below " + folder.string());
  }
  return whole.string();
}

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
