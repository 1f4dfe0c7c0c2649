#ifndef PLACE_MEMORY_CORE_STORE_STORE_SCANS_H
#define PLACE_MEMORY_CORE_STORE_STORE_SCANS_H

#include "core/map/kept_map.h"
#include "core/store/sqlite.h"
#include "core/store/store_head.h"
#include "core/store/store_reader.h"

namespace place_memory::core {

/// Scans, ties and errors of the wheels. Rows that are not as they were written are left out and
/// named; nodes are numbered anew without them. `head` is nothing where it is damaged: totals are
/// not compared then. `found`: of these tables.
KeptMap readScans(SqliteDatabase& database, const StoreHead* head, Damages& damages,
                  StoreTotals& found);

/// Within a transaction: takes the place of what is there. Rows that are the same already are not
/// touched. `head` follows what is written.
void writeScans(SqliteDatabase& database, const KeptMap& scans, StoreHead& head);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_SCANS_H
