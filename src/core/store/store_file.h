#ifndef PLACE_MEMORY_CORE_STORE_STORE_FILE_H
#define PLACE_MEMORY_CORE_STORE_STORE_FILE_H

#include <cstdint>
#include <memory>
#include <string>

#include "core/store/sqlite.h"
#include "place_memory/core/store_opening.h"

namespace place_memory::core {

struct StoreFile {
  std::unique_ptr<SqliteDatabase> database;
  std::uint32_t format = 0;
  bool checked = true;        ///< in full; otherwise what is read has to be checked as it is read
  std::string why_read_only;  ///< "" where it can be written
  /// A change that was cut off could not be undone in the file: it is undone in memory.
  bool is_copy = false;
};

/// Where a store lies whose path is given as people write it: absolute, "~" resolved, and links to
/// files followed. "" stays "".
std::string storePath(const std::string& path);

/// Opens and locks a store's file, or creates it where there is none. A change that was cut off is
/// undone first, unless the journal beside the file is not of it. Throws StoreError where it is not
/// a sound store of a format that is known, or cannot be read or locked; the file is then as it
/// was. `path` is storePath()'s. A new one is for grids with cells of `cell_size` [m].
StoreFile openStoreFile(const std::string& path, double cell_size, const StoreOpening& opening);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_FILE_H
