#include "core/store/sqlite.h"

#include "core/store/place_store.h"

namespace place_memory::core {
namespace {

// Long enough for the program that had the file before to end.
constexpr int kBusyTimeoutMs = 2000;

[[noreturn]] void throwSqliteError(const std::string& path, sqlite3* handle) {
  const std::string reason = sqlite3_errmsg(handle);
  switch (sqlite3_errcode(handle)) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      throwStoreError(path, "is damaged: " + reason);
    case SQLITE_BUSY:
      throwStoreError(path, "is in use by another program: " + reason);
    default:
      throwStoreError(path, reason);
  }
}

// With its journal open all the time SQLite would go on writing to a file without a name.
void requireFileInPlace(SqliteDatabase& database) {
  int moved = 0;
  sqlite3_file_control(database.handle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  if (moved != 0) {
    throwStoreError(database.path(),
                    "was moved, replaced or deleted since it was opened: start the node again");
  }
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
  check(sqlite3_bind_text64(handle_.get(), ++parameters_, text.data(), text.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
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

std::string SqliteStatement::text(int column) const {
  const auto* bytes = static_cast<const char*>(blob(column));
  return bytes == nullptr ? std::string() : std::string(bytes, size(column));
}

void SqliteStatement::check(int code) {
  if (code != SQLITE_OK) throwSqliteError(database_.path(), database_.handle());
}

SqliteTransaction::SqliteTransaction(SqliteDatabase& database)
    : database_(database), is_outermost_(sqlite3_get_autocommit(database.handle()) != 0) {
  if (!is_outermost_) return;
  requireFileInPlace(database);
  database.execute("BEGIN IMMEDIATE");
}

SqliteTransaction::~SqliteTransaction() {
  // After a failed commit SQLite may have rolled back by itself already.
  const bool is_open = sqlite3_get_autocommit(database_.handle()) == 0;
  if (is_outermost_ && is_open) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void SqliteTransaction::commit() {
  if (is_outermost_) database_.execute("COMMIT");
}

}  // namespace place_memory::core
