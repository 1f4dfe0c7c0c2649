#ifndef PLACE_MEMORY_CORE_STORE_UNDONE_COPY_H
#define PLACE_MEMORY_CORE_STORE_UNDONE_COPY_H

#include <memory>
#include <string>

#include "core/store/sqlite.h"

namespace place_memory::core {

/// In memory, what a store is once the change is undone that was cut off in its file: for a disk on
/// which it cannot be undone, as it is full or read-only. For a moment a copy lies in the folder of
/// temporary files. Throws SqliteError, and std::filesystem::filesystem_error where there is no
/// room for that either.
std::unique_ptr<SqliteDatabase> undoneCopy(const std::string& path);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_UNDONE_COPY_H
