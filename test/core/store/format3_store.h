#ifndef PLACE_MEMORY_TEST_CORE_STORE_FORMAT3_STORE_H
#define PLACE_MEMORY_TEST_CORE_STORE_FORMAT3_STORE_H

#include <string>

#include "core/store/packed_bytes.h"
#include "core/store/row_checksum.h"
#include "core/store/sqlite.h"
#include "core/store/store_head.h"

namespace place_memory::core {

/// Makes of a store in the newest format, without scans of drives, what the version wrote that knew
/// format 3.
inline void makeFormat3(const std::string& path) {
  SqliteDatabase database(path, false);
  const StoreHead head = *readHead(database);
  BytePacker totals;
  for (std::size_t i = 0; i < kStoreTablesOfFormat3; ++i) {
    const TableTotal& total = head.totals.of(static_cast<StoreTable>(i));
    totals.add(total.rows).add(total.sum);
  }
  const std::uint64_t checksum = RowChecksum()
                                     .add(std::int64_t{1})
                                     .add(head.identity.data(), head.identity.size())
                                     .add(head.cell_size)
                                     .add(head.next_place)
                                     .add(head.next_session)
                                     .add(head.version)
                                     .add(std::int64_t{head.stamp.count()})
                                     .add(totals.bytes().data(), totals.bytes().size())
                                     .value();
  database.execute(
      "DROP TABLE tie; DROP TABLE wheels; DROP TABLE node;"
      "CREATE TABLE node(id INTEGER PRIMARY KEY, session INTEGER, x REAL, y REAL, yaw REAL, "
      "stamp_ns INTEGER, readings BLOB, checksum INTEGER); PRAGMA user_version = 3");
  SqliteStatement(database, "UPDATE store SET totals = ?, checksum = ?")
      .bind(totals.bytes().data(), totals.bytes().size())
      .bind(static_cast<std::int64_t>(checksum))
      .run();
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_FORMAT3_STORE_H
