#include "core/store/undone_copy.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/store/store_copy.h"
#include "core/store/store_journal.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

/// A folder that nobody else looks into, and that goes with this object.
class PrivateFolder {
 public:
  explicit PrivateFolder(const fs::path& parent) {
    std::string name = (parent / "place_memory_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw fs::filesystem_error("cannot be made", name,
                                 std::error_code(errno, std::generic_category()));
    }
    path_ = name;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::unique_ptr<SqliteDatabase> undoneBy(const std::string& path, const fs::path& parent) {
  const PrivateFolder folder(parent);
  const std::string copy = (folder.path() / "store").string();
  fs::copy_file(path, copy);
  fs::copy_file(journalOf(path), journalOf(copy));
  for (const std::string& name : {copy, journalOf(copy)}) {
    fs::permissions(name, fs::perms::owner_read | fs::perms::owner_write);
  }
  SqliteDatabase undone(copy, false);
  SqliteStatement(undone, "SELECT count(*) FROM sqlite_master").run();
  auto database = std::make_unique<SqliteDatabase>(":memory:", true);
  copyDatabase(undone, *database);
  database->standFor(path);
  return database;
}

}  // namespace

std::unique_ptr<SqliteDatabase> undoneCopy(const std::string& path) {
  // In memory, where there is such a folder; the other one may lie on the disk that is full.
  const fs::path in_memory = "/dev/shm";
  try {
    return undoneBy(path, in_memory);
  } catch (const fs::filesystem_error&) {
    return undoneBy(path, fs::temp_directory_path());
  }
}

}  // namespace place_memory::core
