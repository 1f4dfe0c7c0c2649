#ifndef PLACE_MEMORY_CORE_STORE_STORE_SCHEMA_H
#define PLACE_MEMORY_CORE_STORE_STORE_SCHEMA_H

#include <cstdint>

#include "core/store/sqlite.h"

namespace place_memory::core {

constexpr std::uint32_t kStoreApplicationId = 0x504c4d59;  // "PLMY"
constexpr std::uint32_t kStoreFormat = 3;
constexpr std::uint32_t kOldestStoreFormat = 1;

/// Makes the tables of format 3 in a new database, with pages so small that a change writes little.
void createSchema(SqliteDatabase& database);

/// Throws StoreError where a database of that format has not its tables: of format 3 to the letter.
void checkSchema(SqliteDatabase& database, std::uint32_t format);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_SCHEMA_H
