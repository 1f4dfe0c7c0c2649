#include "core/store/store_copy.h"

#include <filesystem>

#include "core/store/file_header.h"
#include "core/store/store_schema.h"
#include "core/store/unfinished_file.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

// What lies there now may go.
void requireReplaceable(const SqliteDatabase& from, const std::string& path) {
  if (!fs::exists(fs::symlink_status(path))) return;
  std::error_code error;
  if (fs::equivalent(path, from.path(), error)) {
    throwStoreError(path, "is the store itself, which is kept there already: name another file");
  }
  FileHeader header;
  const bool is_store = fs::is_regular_file(path) && header.read(path) && header.isSqlite() &&
                        header.applicationId() == kStoreApplicationId;
  if (!is_store) {
    throwStoreError(path,
                    "is there and is no place store; it was left as it is. Name another file");
  }
  SqliteDatabase older(path, false);
  if (!older.isReadOnly()) older.execute("BEGIN EXCLUSIVE; ROLLBACK");  // throws where it is in use
}

void requireSound(SqliteDatabase& copy) {
  SqliteStatement check(copy, "PRAGMA quick_check(1)");
  if (!check.step() || check.text(0) != "ok") {
    throwStoreError(copy.path(), "the copy is damaged: " + check.text(0));
  }
}

}  // namespace

void copyDatabase(const SqliteDatabase& from, SqliteDatabase& to) {
  sqlite3_backup* copy = sqlite3_backup_init(to.handle(), "main", from.handle(), "main");
  const int result = copy == nullptr ? SQLITE_ERROR : sqlite3_backup_step(copy, -1);
  if (copy != nullptr) sqlite3_backup_finish(copy);
  if (result != SQLITE_DONE) {
    throw SqliteError("place store " + to.path() + ": " + sqlite3_errstr(result), result);
  }
}

void saveCopy(const SqliteDatabase& from, const std::string& path) {
  try {
    const fs::path folder = fs::path(path).parent_path();
    if (!fs::is_directory(folder)) {
      throwStoreError(path, "cannot be made: there is no folder " + folder.string());
    }
    requireReplaceable(from, path);
    removeUnfinished(path);
    UnfinishedFile file(path);
    {
      SqliteDatabase copy(file.name(), true);
      copyDatabase(from, copy);
      requireSound(copy);
    }
    file.publishOver();
  } catch (const fs::filesystem_error& error) {
    throwStoreError(path, error.code().message());
  }
}

}  // namespace place_memory::core
