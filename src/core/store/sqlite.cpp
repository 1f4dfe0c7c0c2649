#include "core/store/sqlite.h"

namespace place_memory::core {
namespace {

// Long enough for the program that had the file before to end.
constexpr int kBusyTimeoutMs = 2000;

[[noreturn]] void throwSqliteError(const std::string& path, sqlite3* handle) {
  const int code = sqlite3_errcode(handle) & 0xff;
  std::string reason = sqlite3_errmsg(handle);
  if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) reason.insert(0, "is damaged: ");
  if (code == SQLITE_BUSY) reason.insert(0, "is in use by another program: ");
  throw SqliteError("place store " + path + ": " + reason, code);
}

}  // namespace

void throwStoreError(const std::string& path, const std::string& reason) {
  throw StoreError("place store " + path + ": " + reason);
}

SqliteDatabase::SqliteDatabase(const std::string& path, bool create) : path_(path) {
  const int flags = SQLITE_OPEN_READWRITE | (create ? SQLITE_OPEN_CREATE : 0);
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &handle, flags, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) throwSqliteError(path, handle);
  sqlite3_busy_timeout(handle, kBusyTimeoutMs);
}

bool SqliteDatabase::hasMoved() const {
  int moved = 0;
  sqlite3_file_control(handle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

void SqliteDatabase::execute(const std::string& sql) {
  if (sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    throwSqliteError(path_, handle());
  }
}

SqliteStatement::SqliteStatement(SqliteDatabase& database, const std::string& sql)
    : database_(database) {
  sqlite3_stmt* handle = nullptr;
  check(sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &handle, nullptr));
  handle_.reset(handle);
}

SqliteStatement& SqliteStatement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(handle_.get(), ++parameters_, value));
  return *this;
}

SqliteStatement& SqliteStatement::bind(double value) {
  check(sqlite3_bind_double(handle_.get(), ++parameters_, value));
  return *this;
}

SqliteStatement& SqliteStatement::bind(const std::string& text) {
  check(sqlite3_bind_text64(handle_.get(), ++parameters_, text.data(), text.size(), SQLITE_STATIC,
                            SQLITE_UTF8));
  return *this;
}

SqliteStatement& SqliteStatement::bind(const void* bytes, std::size_t size) {
  check(sqlite3_bind_blob64(handle_.get(), ++parameters_, bytes, size, SQLITE_STATIC));
  return *this;
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(handle_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) throwSqliteError(database_.path(), database_.handle());
  return false;
}

void SqliteStatement::run() {
  while (step()) {
  }
  reset();
}

void SqliteStatement::reset() {
  sqlite3_reset(handle_.get());  // says again what step() said
  parameters_ = 0;
}

std::string SqliteStatement::text(int column) const {
  const auto* bytes = static_cast<const char*>(blob(column));
  return bytes == nullptr ? std::string() : std::string(bytes, size(column));
}

void SqliteStatement::check(int code) {
  if (code != SQLITE_OK) throwSqliteError(database_.path(), database_.handle());
}

SqliteBlob::SqliteBlob(SqliteDatabase& database, const char* table, const char* column,
                       std::int64_t row)
    : database_(database) {
  sqlite3_blob* handle = nullptr;
  const int code = sqlite3_blob_open(database.handle(), "main", table, column, row, 1, &handle);
  handle_.reset(handle);
  check(code);
}

void SqliteBlob::read(void* bytes, std::size_t size, std::size_t offset) {
  check(sqlite3_blob_read(handle_.get(), bytes, static_cast<int>(size), static_cast<int>(offset)));
}

void SqliteBlob::write(const void* bytes, std::size_t size, std::size_t offset) {
  check(sqlite3_blob_write(handle_.get(), bytes, static_cast<int>(size), static_cast<int>(offset)));
}

void SqliteBlob::check(int code) {
  if (code != SQLITE_OK) throwSqliteError(database_.path(), database_.handle());
}

SqliteTransaction::SqliteTransaction(SqliteDatabase& database) : database_(database) {
  // With its journal open all the time SQLite would go on writing to a file without a name.
  if (database.hasMoved()) {
    throwStoreError(database.path(),
                    "was moved, replaced or deleted since it was opened: start the node again");
  }
  database.execute("BEGIN IMMEDIATE");
}

SqliteTransaction::~SqliteTransaction() {
  // After a failed commit SQLite may have rolled back by itself already.
  if (sqlite3_get_autocommit(database_.handle()) == 0) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void SqliteTransaction::commit() { database_.execute("COMMIT"); }

}  // namespace place_memory::core
