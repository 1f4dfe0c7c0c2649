#ifndef PLACE_MEMORY_CORE_STORE_SQLITE_H
#define PLACE_MEMORY_CORE_STORE_SQLITE_H

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "place_memory/core/store_opening.h"

namespace place_memory::core {

/// Throws a StoreError that names the file.
[[noreturn]] void throwStoreError(const std::string& path, const std::string& reason);

/// What SQLite could not do.
class SqliteError : public StoreError {
 public:
  SqliteError(const std::string& what, int code) : StoreError(what), code_(code) {}
  /// One of SQLite's primary result codes, as SQLITE_CORRUPT.
  int code() const { return code_; }
  /// Whether a disk or its rights were the reason, which may get better, and not what is on it.
  bool isOfDisk() const {
    return code_ == SQLITE_FULL || code_ == SQLITE_IOERR || code_ == SQLITE_READONLY ||
           code_ == SQLITE_CANTOPEN || code_ == SQLITE_PERM;
  }

 private:
  int code_;
};

/// An open SQLite database. Failures throw SqliteError, naming the file and SQLite's reason.
class SqliteDatabase {
 public:
  /// `path` as sqlite3_open_v2() takes it; the file is created where `create` is set. A file that
  /// may not be written is opened for reading.
  SqliteDatabase(const std::string& path, bool create);

  const std::string& path() const { return path_; }
  sqlite3* handle() const { return handle_.get(); }
  bool isReadOnly() const { return sqlite3_db_readonly(handle(), "main") == 1; }
  /// Whether another file, or none, has the name by now.
  bool hasMoved() const;

  /// Runs statements that return no rows.
  void execute(const std::string& sql);

  /// Its errors name another file from now on: of which it holds what that one should.
  void standFor(const std::string& path) { path_ = path; }

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };

  std::string path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// One SQL statement. Parameters and columns count from 0 in the order they are written.
class SqliteStatement {
 public:
  SqliteStatement(SqliteDatabase& database, const std::string& sql);

  SqliteStatement& bind(std::int64_t value);
  SqliteStatement& bind(double value);
  /// The text has to stay until the statement ends.
  SqliteStatement& bind(const std::string& text);
  /// The bytes have to stay until the statement ends.
  SqliteStatement& bind(const void* bytes, std::size_t size);

  /// Goes to the next row; false after the last one.
  bool step();
  /// Goes through all rows, after which parameters can be bound anew.
  void run();
  /// Before the last row: parameters can be bound anew.
  void reset();

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

/// The bytes of one value of a row. They are read and written in part, so that only the pages they
/// lie on are.
class SqliteBlob {
 public:
  SqliteBlob(SqliteDatabase& database, const char* table, const char* column, std::int64_t row);

  std::size_t size() const { return static_cast<std::size_t>(sqlite3_blob_bytes(handle_.get())); }
  void read(void* bytes, std::size_t size, std::size_t offset);
  void write(const void* bytes, std::size_t size, std::size_t offset);

 private:
  struct Close {
    void operator()(sqlite3_blob* handle) const { sqlite3_blob_close(handle); }
  };

  void check(int code);

  SqliteDatabase& database_;
  std::unique_ptr<sqlite3_blob, Close> handle_;
};

/// Undoes every change since it began, unless commit() was reached.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  SqliteDatabase& database_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_SQLITE_H
