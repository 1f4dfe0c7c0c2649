#include "core/store/store_file.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/store/file_header.h"
#include "core/store/store_head.h"
#include "core/store/store_journal.h"
#include "core/store/store_schema.h"
#include "core/store/undone_copy.h"
#include "core/store/unfinished_file.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

bool hasJournal(const std::string& path) { return fs::exists(journalOf(path)); }

// SQLite would start afresh in an empty file and write to any database of its own format, so what
// the file is gets settled before SQLite sees it.
FileHeader readHeader(const std::string& path) {
  FileHeader header;
  if (!header.read(path)) {
    throwStoreError(path, "cannot be read as a file, or was cut short: it has no complete header");
  }
  if (!header.isSqlite() || header.applicationId() != kStoreApplicationId) {
    throwStoreError(path, "is not a place store; it was left as it is. Name another file");
  }
  return header;
}

// Power that fails during a change leaves a file that is neither as before nor as after it, and a
// journal by which SQLite undoes the change when it reads. Only then is it known what the file is.
// Returns why it cannot be undone in the file, or "".
std::string undoUnfinishedChange(const std::string& path) {
  if (!hasJournal(path)) return "";
  readHeader(path);
  if (isJournalOfAnotherFile(path)) {
    throwStoreError(path, "the change that was cut off by " + journalOf(path) +
                              " was one of another file, or of this one at another time: both were "
                              "left as they are. Where the store is a copy that was put here, move "
                              "that journal away; otherwise put the file back that it belongs to");
  }
  try {
    SqliteDatabase database(path, false);
    SqliteStatement(database, "SELECT count(*) FROM sqlite_master").run();
  } catch (const SqliteError& error) {
    if (!error.isOfDisk()) throw;
    return error.what();
  }
  return "";
}

void requireKnownFormat(const std::string& path, std::uint32_t format) {
  if (format >= kOldestStoreFormat && format <= kStoreFormat) return;
  throwStoreError(path, "has format " + std::to_string(format) + ", but " +
                            std::to_string(kStoreFormat) +
                            " is the last one known here: it was written by a newer version");
}

// Returns the format.
std::uint32_t checkHeader(const std::string& path) {
  const FileHeader header = readHeader(path);
  const std::uint32_t format = header.userVersion();
  requireKnownFormat(path, format);
  const std::uint64_t size = fs::file_size(path);
  if (size < header.fileSize()) {
    throwStoreError(path, "was cut short: " + std::to_string(size) + " of " +
                              std::to_string(header.fileSize()) + " bytes are there");
  }
  return format;
}

void createFile(const std::string& path, double cell_size) {
  UnfinishedFile file(path);
  {
    SqliteDatabase database(file.name(), true);
    createSchema(database);
    StoreHead head;
    head.identity = makeIdentity();
    head.cell_size = cell_size;
    writeHead(database, head);
  }
  file.publish();
}

void requireFile(const std::string& path, double cell_size) {
  const fs::path folder = fs::path(path).parent_path();
  if (!fs::is_directory(folder)) {
    throwStoreError(path, "cannot be made: there is no folder " + folder.string());
  }
  if (!fs::exists(path)) {
    removeUnfinished(path);
    createFile(path, cell_size);
  } else if (!fs::is_regular_file(path)) {
    throwStoreError(
        path, fs::is_directory(path) ? "is a folder; name a file" : "is no file; name another one");
  }
}

bool isBusy(const SqliteError& error) { return error.code() == SQLITE_BUSY; }

// Returns why it cannot be written, or "". SQLite opens for reading what it may not write, so a
// change is tried and taken back.
std::string tryToWrite(SqliteDatabase& database, std::uint32_t format) {
  std::string reason;
  try {
    if (database.isReadOnly()) {
      return "place store " + database.path() + ": the file may not be written";
    }
    database.execute("BEGIN EXCLUSIVE; PRAGMA user_version = " + std::to_string(format));
  } catch (const SqliteError& error) {
    if (isBusy(error) || error.code() == SQLITE_CORRUPT) throw;
    reason = error.what();
  }
  if (sqlite3_get_autocommit(database.handle()) == 0) database.execute("ROLLBACK");
  return reason;
}

void lock(SqliteDatabase& database) {
  database.execute("PRAGMA locking_mode = EXCLUSIVE");
  if (database.isReadOnly()) {
    SqliteStatement(database, "SELECT count(*) FROM sqlite_master").run();
  } else {
    database.execute("BEGIN EXCLUSIVE; COMMIT");
  }
  if (database.hasMoved()) {  // who had it before has brought it to a new format meanwhile
    throwStoreError(database.path(), "is in use by another program, which has just replaced it");
  }
}

// Reads the whole file.
void checkStructure(SqliteDatabase& database, std::uint32_t format) {
  // Of old formats the indexes too, which newer ones have not.
  SqliteStatement check(database, format < kFirstFormatWithoutIndexes ? "PRAGMA integrity_check(1)"
                                                                      : "PRAGMA quick_check(1)");
  if (!check.step() || check.text(0) != "ok") {
    throwStoreError(database.path(), "is damaged: " + check.text(0));
  }
}

// Where a change that was cut off cannot be undone in the file, because of `why`.
StoreFile openCopy(const std::string& path, const std::string& why) {
  StoreFile file;
  file.is_copy = true;
  file.why_read_only = why;
  file.database = undoneCopy(path);
  SqliteStatement format(*file.database, "PRAGMA user_version");
  format.step();
  file.format = static_cast<std::uint32_t>(format.integer(0));
  requireKnownFormat(path, file.format);
  checkStructure(*file.database, file.format);
  checkSchema(*file.database, file.format);
  return file;
}

StoreFile openFile(const std::string& path, double cell_size, const StoreOpening& opening) {
  requireFile(path, cell_size);
  // Whoever ends in good order takes the journal along.
  const bool ended_well = !hasJournal(path);
  const std::string why_not_undone = undoUnfinishedChange(path);
  if (!why_not_undone.empty()) return openCopy(path, why_not_undone);
  removeUnfinished(path);
  StoreFile file;
  file.format = checkHeader(path);
  const std::uintmax_t size = fs::file_size(path);
  file.checked = size <= opening.full_check_size || !ended_well || file.format < kStoreFormat;
  file.database = std::make_unique<SqliteDatabase>(path, false);
  file.why_read_only = tryToWrite(*file.database, file.format);
  lock(*file.database);
  if (file.checked) {
    if (opening.progress && size > opening.full_check_size) {
      opening.progress("checking all " + std::to_string(size >> 20U) + " MiB of the store");
    }
    checkStructure(*file.database, file.format);
  }
  checkSchema(*file.database, file.format);
  return file;
}

}  // namespace

std::string storePath(const std::string& path) {
  if (path.empty()) return path;
  std::string absolute = path;
  const char* home = std::getenv("HOME");
  if (home != nullptr && (path == "~" || path.compare(0, 2, "~/") == 0)) {
    absolute = home + path.substr(1);
  }
  std::error_code error;
  // A link whose file is still to be made, too.
  for (int links = 0; links < 40 && fs::is_symlink(absolute, error); ++links) {
    absolute = (fs::path(absolute).parent_path() / fs::read_symlink(absolute, error)).string();
  }
  const fs::path canonical = fs::weakly_canonical(fs::absolute(absolute), error);
  return error ? fs::absolute(absolute).lexically_normal().string() : canonical.string();
}

StoreFile openStoreFile(const std::string& path, double cell_size, const StoreOpening& opening) {
  try {
    return openFile(path, cell_size, opening);
  } catch (const fs::filesystem_error& error) {
    throwStoreError(path, error.code().message());
  }
}

}  // namespace place_memory::core
