#ifndef PLACE_MEMORY_CORE_STORE_OLD_STORE_H
#define PLACE_MEMORY_CORE_STORE_OLD_STORE_H

#include <functional>
#include <vector>

#include "core/store/sqlite.h"
#include "place_memory/core/map_change.h"

namespace place_memory::core {

// Stores of format 1 and 2, which are read and never written. They knew labels, locations, links
// and grids: the rest is made up, alike however often a store is read, so that what comes of two
// copies of one store can be told to be the same.

/// Throws StoreError where its tables do not belong together or its cells have another size [m].
void checkOldStore(SqliteDatabase& database, double cell_size);

/// Higher than any id that was given.
PlaceId oldNextId(SqliteDatabase& database);

/// Calls with changes that together make its map, from version 1 on. Throws StoreError where a row
/// is damaged.
void readOldStore(SqliteDatabase& database, double cell_size,
                  const std::function<void(const MapChange&)>& call);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_OLD_STORE_H
