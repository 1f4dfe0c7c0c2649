#ifndef PLACE_MEMORY_TOOLS_STORE_REPORTS_H
#define PLACE_MEMORY_TOOLS_STORE_REPORTS_H

#include <string>

#include "config/parameters.h"
#include "tools/record_table.h"

namespace place_memory::tools {

/// Which places of a store look alike, and what parts them. Throws CommandError and StoreError.
RecordTable twinTable(const std::string& store, const config::Parameters& parameters);

/// What has changed at the places of a store, or at the one with that label: since they were
/// learned, or where another store is named, as its places show that are RECOGNIZED. Throws
/// likewise.
RecordTable changeTable(const std::string& store, const std::string& label,
                        const std::string& later_store, const config::Parameters& parameters);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_STORE_REPORTS_H
