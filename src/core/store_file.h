#ifndef PLACE_MEMORY_CORE_STORE_FILE_H
#define PLACE_MEMORY_CORE_STORE_FILE_H

#include <memory>
#include <string>

#include "sqlite.h"

namespace place_memory::core {

/// Opens and locks a store's file, or creates it where there is none; "" stands for memory. Throws
/// StoreError where it is not a sound store of this version; the file is then as it was.
std::unique_ptr<SqliteDatabase> openStoreFile(const std::string& path);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_FILE_H
