#ifndef PLACE_MEMORY_CORE_STORE_STORE_FILE_H
#define PLACE_MEMORY_CORE_STORE_STORE_FILE_H

#include <memory>
#include <string>

#include "core/store/place_store.h"
#include "core/store/sqlite.h"

namespace place_memory::core {

struct StoreFile {
  std::unique_ptr<SqliteDatabase> database;
  bool checked = true;  ///< in full; otherwise what is read has to be checked as it is read
  bool old = false;     ///< of an older version, checked in full: addPlanesToStore() renews it
};

/// Opens and locks a store's file, or creates it where there is none; "" stands for memory. Throws
/// StoreError where it is not a sound store of a version that is known, or cannot be written; the
/// file is then as it was.
StoreFile openStoreFile(const std::string& path, const StoreOpening& opening);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_FILE_H
