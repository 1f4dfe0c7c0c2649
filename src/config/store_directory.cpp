#include "config/store_directory.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "config/store_path.h"
#include "support/text.h"

namespace place_memory::config {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPathBytes = 1024;

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

bool isBelow(const fs::path& path, const fs::path& folder) {
  const auto [of_folder, of_path] =
      std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return of_folder == folder.end() && of_path != path.end();
}

}  // namespace

std::string pathInside(const std::string& directory, const std::string& path) {
  // Which goes into answers.
  if (path.size() > kMostPathBytes) {
    refuse("path has " + std::to_string(path.size()) + " bytes, more than the " +
           std::to_string(kMostPathBytes) + " that a path may have");
  }
  if (directory.empty()) {
    refuse("no folder is set for such files: give parameter store_directory, or store");
  }
  std::error_code error;
  const fs::path folder = fs::canonical(directory, error);
  if (error) refuse("parameter store_directory: there is no folder " + directory);
  const std::string problem = checkStorePath(path);
  if (path.empty() || !problem.empty()) {
    refuse("path " + (path.empty() ? "must not be empty" : problem));
  }
  const std::string where = " lies outside of " + folder.string() +
                            ": name a file below it, or set parameter store_directory otherwise";
  const fs::path named(path);
  if (std::find(named.begin(), named.end(), "..") != named.end()) {
    refuse("path must not hold \"..\"");
  }
  const fs::path whole =
      path.front() == '~' ? fs::path(absoluteStorePath(path)) : fs::path(directory) / named;
  const bool leads_nowhere = fs::is_symlink(fs::symlink_status(whole, error)) && !fs::exists(whole);
  const fs::path resolved = fs::weakly_canonical(whole, error);
  if (error || leads_nowhere || !isBelow(resolved, folder)) {
    refuse(support::printable(path) + where);
  }
  return resolved.string();
}

}  // namespace place_memory::config
