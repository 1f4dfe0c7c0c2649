#ifndef PLACE_MEMORY_CORE_STORE_STORE_MIGRATION_H
#define PLACE_MEMORY_CORE_STORE_STORE_MIGRATION_H

#include <memory>
#include <string>

#include "core/store/store_file.h"
#include "place_memory/core/store_opening.h"

namespace place_memory::core {

/// Brings a store of an old format, which is open and locked, to this one.
///
/// The new file is made beside the old one, which gets a second name ("places.db.format-2") before
/// the new one takes the first: whenever this is cut off, one of them bears it whole. Where nothing
/// can be written the result lies in memory, says why, and `held` goes on locking the old file.
/// Throws StoreError where the old one is damaged or has cells of another size [m]; it is then as
/// it was.
StoreFile migrateStore(StoreFile old, const std::string& path, double cell_size,
                       const StoreOpening& opening, std::unique_ptr<SqliteDatabase>& held);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_MIGRATION_H
