#ifndef PLACE_MEMORY_CORE_STORE_STORE_MIGRATION_H
#define PLACE_MEMORY_CORE_STORE_STORE_MIGRATION_H

#include "core/store/place_store.h"
#include "core/store/sqlite.h"

namespace place_memory::core {

/// The table that format 2 has and format 1 has not.
inline constexpr char kPlanesSchema[] = R"(
  CREATE TABLE planes(
    place_id INTEGER PRIMARY KEY REFERENCES place(id) ON DELETE CASCADE,
    checksum INTEGER NOT NULL,    -- FNV-1a of the words of cells
    cells BLOB NOT NULL           -- which are occupied, then which are empty: a bit a cell
  );
)";

/// Brings a sound store of format 1, which has no bit planes, to format 2, in one transaction.
/// Throws StoreError; the store is then as it was.
void addPlanesToStore(SqliteDatabase& database, const StoreProgress& progress);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_MIGRATION_H
