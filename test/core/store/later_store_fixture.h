#ifndef PLACE_MEMORY_TEST_CORE_STORE_LATER_STORE_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_STORE_LATER_STORE_FIXTURE_H

#include <string>
#include <vector>

#include "core/store/packed_bytes.h"
#include "core/store/row_checksum.h"
#include "core/store/sqlite.h"
#include "core/store/store_fixture.h"
#include "core/store/store_head.h"

namespace place_memory::core {

// Stores as the versions wrote them that knew formats 3 and 4, made of one of the newest format.

/// Of formats 3 and 4, to the letter.
constexpr char kLinkTableOfFormat4[] = R"(CREATE TABLE link(
    id INTEGER PRIMARY KEY,     -- first_id << 20 | a number of its own
    first_id INTEGER,           -- the lower one
    second_id INTEGER,
    x REAL,                     -- pose of the second place in the first one's frame [m]
    y REAL,
    yaw REAL,                   -- [rad]
    covariance BLOB,            -- of that pose, row by row: 9 doubles
    forward_succeeded INTEGER,  -- traversals from the first to the second
    forward_failed INTEGER,
    forward_last_ns INTEGER,    -- since the epoch; 0: none
    backward_succeeded INTEGER,
    backward_failed INTEGER,
    backward_last_ns INTEGER,
    checksum INTEGER
  ))";

inline void writeHeadOf(std::uint32_t format, SqliteDatabase& database, const StoreHead& head) {
  BytePacker totals;
  for (std::size_t i = 0; i < storeTablesOf(format); ++i) {
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
  SqliteStatement(database, "UPDATE store SET totals = ?, checksum = ?")
      .bind(totals.bytes().data(), totals.bytes().size())
      .bind(static_cast<std::int64_t>(checksum))
      .run();
}

inline std::uint64_t writeLinkOfFormat4(SqliteDatabase& database, std::int64_t id,
                                        const PlaceLink& link) {
  RowChecksum checksum;
  checksum.add(id).add(link.first).add(link.second).add(link.first_from_second);
  BytePacker covariance;
  for (const double element : link.covariance) {
    checksum.add(element);
    covariance.add(element);
  }
  SqliteStatement row(database, "INSERT INTO link VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  row.bind(id).bind(link.first).bind(link.second);
  row.bind(link.first_from_second.x).bind(link.first_from_second.y);
  row.bind(link.first_from_second.yaw);
  row.bind(covariance.bytes().data(), covariance.bytes().size());
  for (const LinkDirection* direction : {&link.forward, &link.backward}) {
    checksum.add(std::uint64_t{direction->succeeded}).add(std::uint64_t{direction->failed});
    checksum.add(std::int64_t{direction->last.count()});
    row.bind(std::int64_t{direction->succeeded}).bind(std::int64_t{direction->failed});
    row.bind(std::int64_t{direction->last.count()});
  }
  row.bind(static_cast<std::int64_t>(checksum.value())).run();
  return checksum.value();
}

/// Of links it keeps what format 4 knew, of traversals nothing.
inline void makeFormat4(const std::string& path) {
  const std::vector<PlaceLink> links = PlaceStore(path, kDefaultCellSize).map().links();
  SqliteDatabase database(path, false);
  StoreHead head = *readHead(database);
  database.execute("DROP TABLE traversal; DROP TABLE link");
  database.execute(kLinkTableOfFormat4);
  head.totals.of(StoreTable::kLink) = TableTotal();
  for (const PlaceLink& link : links) {
    head.totals.of(StoreTable::kLink).add(writeLinkOfFormat4(database, link.first << 20, link));
  }
  database.execute("PRAGMA user_version = 4");
  writeHeadOf(4, database, head);
}

inline void makeFormat3(const std::string& path) {
  makeFormat4(path);
  SqliteDatabase database(path, false);
  const StoreHead head = *readHead(database, storeTablesOf(4));
  database.execute(
      "DROP TABLE tie; DROP TABLE wheels; DROP TABLE node;"
      "CREATE TABLE node(id INTEGER PRIMARY KEY, session INTEGER, x REAL, y REAL, yaw REAL, "
      "stamp_ns INTEGER, readings BLOB, checksum INTEGER); PRAGMA user_version = 3");
  writeHeadOf(3, database, head);
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_LATER_STORE_FIXTURE_H
