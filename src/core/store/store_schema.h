#ifndef PLACE_MEMORY_CORE_STORE_STORE_SCHEMA_H
#define PLACE_MEMORY_CORE_STORE_STORE_SCHEMA_H

#include <cstdint>

#include "core/store/sqlite.h"

namespace place_memory::core {

constexpr std::uint32_t kStoreApplicationId = 0x504c4d59;  // "PLMY"
constexpr std::uint32_t kStoreFormat = 5;
constexpr std::uint32_t kOldestStoreFormat = 1;
constexpr std::uint32_t kFirstFormatWithoutIndexes = 3;

/// Makes the tables of format 5 in a new database, with pages so small that a change writes little.
void createSchema(SqliteDatabase& database);

/// Within a transaction: makes tables of format 3 or 4 those of format 5. Of format 3 table `node`
/// was always empty. Links stay as they were, to their checksums.
void bringSchemaToFormat5(SqliteDatabase& database, std::uint32_t format);

/// Throws StoreError where a database of that format has not its tables: of format 5 to the letter.
void checkSchema(SqliteDatabase& database, std::uint32_t format);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_SCHEMA_H
