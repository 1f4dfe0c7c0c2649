#include "core/store/table_scan.h"

#include <limits>
#include <optional>

namespace place_memory::core {
namespace {

constexpr std::int64_t kBeforeAll = std::numeric_limits<std::int64_t>::min();

// False where the row after it cannot be made out.
bool goOn(SqliteStatement& rows, std::int64_t& last,
          const std::function<void(const SqliteStatement&)>& read) {
  for (;;) {
    try {
      if (!rows.step()) return true;
    } catch (const SqliteError& error) {
      if (error.code() != SQLITE_CORRUPT) throw;
      return false;
    }
    last = rows.integer(0);
    read(rows);
  }
}

// Looks at the keys alone.
std::optional<std::int64_t> keyAfter(SqliteDatabase& database, const TableScan& scan,
                                     std::int64_t last) {
  SqliteStatement query(database, std::string("SELECT ") + scan.key + " FROM " + scan.table +
                                      " WHERE " + scan.key + " > ? ORDER BY " + scan.key +
                                      " LIMIT 1");
  if (!query.bind(last).step()) return std::nullopt;
  return query.integer(0);
}

}  // namespace

void scanTable(SqliteDatabase& database, const TableScan& scan,
               const std::function<void(const SqliteStatement&)>& read,
               const std::function<void(std::int64_t)>& unreadable) {
  const std::string select = std::string("SELECT ") + scan.columns + " FROM " + scan.table +
                             " WHERE " + scan.key + " > ? ORDER BY " + scan.key;
  for (std::int64_t last = kBeforeAll;;) {
    SqliteStatement rows(database, select);
    rows.bind(last);
    if (goOn(rows, last, read)) return;
    const std::optional<std::int64_t> key = keyAfter(database, scan, last);
    if (!key) {
      throwStoreError(database.path(), std::string("is damaged: its table ") + scan.table +
                                           " cannot be read to its end");
    }
    unreadable(*key);
    last = *key;
  }
}

std::string compareTotals(const TableTotal& expected, const TableFindings& found,
                          const std::string& rows) {
  if (found.all.rows < expected.rows) {
    return std::to_string(expected.rows - found.all.rows) + " " + rows + " are missing";
  }
  if (found.all.rows > expected.rows) {
    return std::to_string(found.all.rows - expected.rows) + " " + rows + " are too many";
  }
  if (found.bad == 0 && found.all.sum != expected.sum) {
    return "some " + rows + " are not those that were written last";
  }
  return "";
}

}  // namespace place_memory::core
