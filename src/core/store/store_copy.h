#ifndef PLACE_MEMORY_CORE_STORE_STORE_COPY_H
#define PLACE_MEMORY_CORE_STORE_STORE_COPY_H

#include <string>

#include "core/store/sqlite.h"

namespace place_memory::core {

/// All of a database as it is at this moment, into one that is empty. Throws SqliteError.
void copyDatabase(const SqliteDatabase& from, SqliteDatabase& to);

/// A store's file with all that the open store `from` holds. It is made beside its name, checked,
/// and only then takes the name, from an older store too that nobody uses. Throws StoreError; what
/// had the name is then as it was. `path` is absolute.
void saveCopy(const SqliteDatabase& from, const std::string& path);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_COPY_H
