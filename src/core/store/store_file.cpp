#include "core/store/store_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string_view>
#include <system_error>

#include "core/store/store_migration.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kApplicationId = 0x504c4d59;  // "PLMY"
constexpr std::uint32_t kSchemaVersion = 2;
constexpr std::uint32_t kOldestVersion = 1;

// AUTOINCREMENT is what keeps SQLite from giving the id of a removed place again.
constexpr char kSchema[] = R"(
  CREATE TABLE place(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    label TEXT NOT NULL UNIQUE,
    x REAL NOT NULL,              -- in the map frame [m]
    y REAL NOT NULL,
    yaw REAL NOT NULL,            -- of compass east in the map frame [rad]
    learned_ns INTEGER NOT NULL   -- since the epoch
  );
  CREATE TABLE grid(
    place_id INTEGER PRIMARY KEY REFERENCES place(id) ON DELETE CASCADE,
    cell_size REAL NOT NULL,      -- [m]
    checksum INTEGER NOT NULL,    -- CRC-32 of cells
    cells BLOB NOT NULL           -- one signed byte a cell, row by row from the least y
  );
  CREATE TABLE link(
    first_id INTEGER NOT NULL REFERENCES place(id) ON DELETE CASCADE,
    second_id INTEGER NOT NULL REFERENCES place(id) ON DELETE CASCADE,
    PRIMARY KEY(first_id, second_id),
    CHECK(first_id < second_id)
  ) WITHOUT ROWID;
  CREATE INDEX link_by_second ON link(second_id);
)";

// The start of every SQLite file: https://www.sqlite.org/fileformat2.html section 1.3.
class FileHeader {
 public:
  static constexpr std::size_t kSize = 100;

  // False where the file is too short to have a header.
  bool read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return static_cast<bool>(file.read(bytes_.data(), kSize));
  }

  bool isSqlite() const {
    constexpr std::string_view kMagic("SQLite format 3\0", 16);
    return std::equal(kMagic.begin(), kMagic.end(), bytes_.begin());
  }
  std::uint32_t applicationId() const { return number(68, 4); }
  std::uint32_t schemaVersion() const { return number(60, 4); }
  std::uint64_t fileSize() const {
    const std::uint32_t page_size = number(16, 2);
    return std::uint64_t{page_size == 1 ? 65536 : page_size} * number(28, 4);
  }

 private:
  std::uint32_t number(std::size_t offset, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = offset; i < offset + size; ++i) {
      value = value << 8U | static_cast<unsigned char>(bytes_[i]);
    }
    return value;
  }

  std::array<char, kSize> bytes_{};
};

// SQLite would start afresh in an empty file and write to any database of its own format, so what
// the file is gets settled before SQLite sees it. Returns its format.
std::uint32_t checkHeader(const std::string& path) {
  FileHeader header;
  if (!header.read(path)) {
    throwStoreError(path, "cannot be read as a file, or was cut short: it has no complete header");
  }
  if (!header.isSqlite() || header.applicationId() != kApplicationId) {
    throwStoreError(path, "is not a place store; it was left as it is. Name another file");
  }
  if (header.schemaVersion() < kOldestVersion || header.schemaVersion() > kSchemaVersion) {
    throwStoreError(path, "has format " + std::to_string(header.schemaVersion()) + ", but " +
                              std::to_string(kSchemaVersion) +
                              " is the last one known here: it was written by a newer version");
  }
  // An unfinished change that the journal is there to undo may have left the size wrong.
  const std::uint64_t size = fs::file_size(path);
  if (size < header.fileSize() && !fs::exists(path + "-journal")) {
    throwStoreError(path, "was cut short: " + std::to_string(size) + " of " +
                              std::to_string(header.fileSize()) + " bytes are there");
  }
  return header.schemaVersion();
}

void createSchema(SqliteDatabase& database) {
  SqliteTransaction transaction(database);
  database.execute(kSchema);
  database.execute(kPlanesSchema);
  database.execute("PRAGMA application_id = " + std::to_string(kApplicationId));
  database.execute("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  transaction.commit();
}

// Another name for each call, of any process.
std::string unfinishedName(const std::string& path) {
  std::random_device random;
  return path + ".new-" + std::to_string(random()) + "-" + std::to_string(random());
}

// Gives the finished file its name, unless somebody else's has it by now: that one stays.
void publish(const std::string& unfinished, const std::string& path) {
  std::error_code error;
  fs::create_hard_link(unfinished, path, error);
  if (error && error != std::errc::file_exists) {
    fs::rename(unfinished, path);  // a file system without hard links
  } else {
    fs::remove(unfinished);
  }
}

void fillNewFile(const std::string& path) {
  SqliteDatabase database(path, true);
  // The largest there is: the bit planes of sixty places then lie together. With SQLite's usual
  // 4096 bytes a start with a million places reads seven times as long from a disk.
  database.execute("PRAGMA page_size = 65536");
  createSchema(database);
}

// Under another name first: whenever this is cut off, no half-made store bears the name.
void createFile(const std::string& path) {
  const std::string unfinished = unfinishedName(path);
  try {
    fillNewFile(unfinished);
    publish(unfinished, path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    throw;
  }
}

bool hasPlaceWithout(SqliteDatabase& database, const std::string& table) {
  return SqliteStatement(
             database, "SELECT id FROM place WHERE id NOT IN (SELECT place_id FROM " + table + ")")
      .step();
}

// Reads the whole file.
void checkContent(SqliteDatabase& database, std::uint32_t version) {
  SqliteStatement check(database, "PRAGMA quick_check(1)");
  if (!check.step() || check.text(0) != "ok") {
    throwStoreError(database.path(), "is damaged: " + check.text(0));
  }
  if (SqliteStatement(database, "PRAGMA foreign_key_check").step() ||
      hasPlaceWithout(database, "grid") || (version > 1 && hasPlaceWithout(database, "planes"))) {
    throwStoreError(database.path(), "is damaged: places, grids and links do not belong together");
  }
}

StoreFile openFile(const std::string& path, const StoreOpening& opening) {
  if (!fs::exists(path)) createFile(path);
  const std::uint32_t version = checkHeader(path);
  const std::uintmax_t size = fs::file_size(path);
  // Whoever ends in good order takes the journal along.
  const bool ended_well = !fs::exists(path + "-journal");
  StoreFile file;
  file.checked = size <= opening.full_check_size || !ended_well || version < kSchemaVersion;
  file.database = std::make_unique<SqliteDatabase>(path, false);
  // SQLite opens what it may not write for reading, so a change is tried and taken back.
  file.database->execute("BEGIN EXCLUSIVE; PRAGMA user_version = " + std::to_string(version) +
                         "; ROLLBACK");
  file.database->execute("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; COMMIT");
  if (file.checked) {
    if (opening.progress && size > opening.full_check_size) {
      opening.progress("checking all " + std::to_string(size >> 20U) + " MiB of the store");
    }
    checkContent(*file.database, version);
  }
  file.old = version < kSchemaVersion;
  return file;
}

}  // namespace

StoreFile openStoreFile(const std::string& path, const StoreOpening& opening) {
  StoreFile file;
  if (path.empty()) {
    file.database = std::make_unique<SqliteDatabase>(":memory:", true);
    createSchema(*file.database);
  } else {
    try {
      file = openFile(fs::absolute(path).string(), opening);
    } catch (const fs::filesystem_error& error) {
      throwStoreError(path, error.code().message());
    }
  }
  file.database->execute("PRAGMA foreign_keys = ON");
  return file;
}

}  // namespace place_memory::core
