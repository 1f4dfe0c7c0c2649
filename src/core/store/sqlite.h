#ifndef PLACE_MEMORY_CORE_STORE_SQLITE_H
#define PLACE_MEMORY_CORE_STORE_SQLITE_H

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace place_memory::core {

/// Throws a StoreError that names the file.
[[noreturn]] void throwStoreError(const std::string& path, const std::string& reason);

/// An open SQLite database. Failures throw StoreError, naming the file and SQLite's reason.
class SqliteDatabase {
 public:
  /// `path` as sqlite3_open_v2() takes it; the file is created where `create` is set.
  SqliteDatabase(const std::string& path, bool create);

  const std::string& path() const { return path_; }
  sqlite3* handle() const { return handle_.get(); }

  /// Runs statements that return no rows.
  void execute(const std::string& sql);

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };

  std::string path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// One SQL statement, run once. Parameters and columns count from 0 in the order they are written.
class SqliteStatement {
 public:
  SqliteStatement(SqliteDatabase& database, const std::string& sql);

  SqliteStatement& bind(std::int64_t value);
  SqliteStatement& bind(double value);
  SqliteStatement& bind(const std::string& text);
  /// The bytes have to stay until the statement ends.
  SqliteStatement& bind(const void* bytes, std::size_t size);

  /// Goes to the next row; false after the last one.
  bool step();
  void run() {
    while (step()) {
    }
  }

  std::int64_t integer(int column) const { return sqlite3_column_int64(handle_.get(), column); }
  double real(int column) const { return sqlite3_column_double(handle_.get(), column); }
  std::string text(int column) const;
  /// Valid until the next step; nullptr where the column is empty.
  const void* blob(int column) const { return sqlite3_column_blob(handle_.get(), column); }
  std::size_t size(int column) const {
    return static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column));
  }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
  };

  void check(int code);

  SqliteDatabase& database_;
  int parameters_ = 0;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// Undoes every change since it began, unless commit() was reached. Within another transaction it
/// is a part of that one, which has the last word.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  SqliteDatabase& database_;
  bool is_outermost_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_SQLITE_H
