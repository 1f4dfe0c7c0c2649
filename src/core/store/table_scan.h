#ifndef PLACE_MEMORY_CORE_STORE_TABLE_SCAN_H
#define PLACE_MEMORY_CORE_STORE_TABLE_SCAN_H

#include <cstdint>
#include <functional>
#include <string>

#include "core/store/sqlite.h"
#include "core/store/store_head.h"

namespace place_memory::core {

struct TableScan {
  const char* table;
  const char* key;      ///< name of its first column
  const char* columns;  ///< the first one is the key
};

/// Calls `read` with each row by rising key, and `unreadable` with the key of each one that SQLite
/// cannot make out. Throws StoreError where the structure of the table is damaged.
void scanTable(SqliteDatabase& database, const TableScan& scan,
               const std::function<void(const SqliteStatement&)>& read,
               const std::function<void(std::int64_t)>& unreadable);

/// What a scan came upon, to be held against what the store says of the table.
struct TableFindings {
  TableTotal all;         ///< with the checksums as they stand in the rows
  std::uint64_t bad = 0;  ///< rows that are not as they were written
};

/// In a sentence what `found` betrays, or "". `rows` is what they are called.
std::string compareTotals(const TableTotal& expected, const TableFindings& found,
                          const std::string& rows);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_TABLE_SCAN_H
