#ifndef PLACE_MEMORY_TEST_CORE_STORE_OLD_STORE_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_STORE_OLD_STORE_FIXTURE_H

#include <boost/crc.hpp>
#include <string>

#include "core/store/store_fixture.h"

namespace place_memory::core {

/// As the versions wrote them that knew formats 1 and 2.
constexpr char kOldSchema[] = R"(
  PRAGMA page_size = 65536;
  CREATE TABLE place(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    label TEXT NOT NULL UNIQUE,
    x REAL NOT NULL,              -- in the map frame [m]
    y REAL NOT NULL,
    yaw REAL NOT NULL,            -- of compass east in the map frame [rad]
    learned_ns INTEGER NOT NULL   -- since the epoch
  );
  CREATE TABLE grid(
    place_id INTEGER PRIMARY KEY REFERENCES place(id) ON DELETE CASCADE,
    cell_size REAL NOT NULL,      -- [m]
    checksum INTEGER NOT NULL,    -- CRC-32 of cells
    cells BLOB NOT NULL           -- one signed byte a cell, row by row from the least y
  );
  CREATE TABLE link(
    first_id INTEGER NOT NULL REFERENCES place(id) ON DELETE CASCADE,
    second_id INTEGER NOT NULL REFERENCES place(id) ON DELETE CASCADE,
    PRIMARY KEY(first_id, second_id),
    CHECK(first_id < second_id)
  ) WITHOUT ROWID;
  CREATE INDEX link_by_second ON link(second_id);
  PRAGMA application_id = 1347177817;
  PRAGMA user_version = 1;
)";

/// What format 2 had besides, and how a version that knew it brought a store of format 1 to it. The
/// bit planes are those of no grid: nobody reads them any more.
constexpr char kToFormat2[] = R"(
  CREATE TABLE planes(
    place_id INTEGER PRIMARY KEY REFERENCES place(id) ON DELETE CASCADE,
    checksum INTEGER NOT NULL,    -- FNV-1a of the words of cells
    cells BLOB NOT NULL           -- which are occupied, then which are empty: a bit a cell
  );
  INSERT INTO planes SELECT place_id, 1, randomblob(1024) FROM grid;
  PRAGMA user_version = 2;
)";

inline std::string hex(const EvidenceGrid& grid) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::int8_t cell : grid.cells()) {
    const auto byte = static_cast<unsigned char>(cell);
    text += {kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return text;
}

/// Three places in a chain, ids 1 to 3, and a fourth that was removed again.
inline void makeOldStore(const std::string& path, int format) {
  std::string sql = kOldSchema;
  for (unsigned id = 1; id <= 3; ++id) {
    const EvidenceGrid grid = makeGrid(id);
    boost::crc_32_type crc;
    crc.process_bytes(grid.cells().data(), grid.cells().size());
    const std::string number = std::to_string(id);
    sql += "INSERT INTO place VALUES(" + number + ", '" + std::string(1, "abc"[id - 1]) + "', " +
           number + ".25, -7.5, 0.0, 100" + number + ");";
    sql += "INSERT INTO grid VALUES(" + number + ", 0.142875, " + std::to_string(crc.checksum()) +
           ", x'" + hex(grid) + "');";
  }
  sql += "INSERT INTO link VALUES(1, 2), (2, 3);";
  sql += "INSERT INTO place VALUES(4, 'd', 0, 0, 0, 0); DELETE FROM place WHERE id = 4;";
  if (format == 2) sql += kToFormat2;
  runSql(path, sql);
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_OLD_STORE_FIXTURE_H
