#include "core/store/store_schema.h"

#include <string>
#include <vector>

namespace place_memory::core {
namespace {

// No table has an index or a constraint: each row is found by its number, and all of it stands
// under the row's own checksum, which takes in the number. So damage of a byte is damage of one
// row, and not of what SQLite derives from it. A row's checksum is that of RowChecksum over the
// columns in their order. (first_id << 20 of a link keeps those of a place together.)
const std::vector<std::string> kTables = {
    R"(CREATE TABLE store(
    id INTEGER PRIMARY KEY,     -- 1: there is one row
    identity BLOB,              -- 16 bytes that no other store has
    cell_size REAL,             -- of all grids [m]
    next_place INTEGER,         -- ids from here on were never given
    next_session INTEGER,
    map_version INTEGER,
    map_stamp_ns INTEGER,       -- of the newest change, since the epoch
    totals BLOB,                -- of each table: number of rows, sum of their checksums mod 2^64
    checksum INTEGER
  ))",
    R"(CREATE TABLE place(
    id INTEGER PRIMARY KEY,
    identity BLOB,              -- 16 bytes that no other place of any store has
    label TEXT,
    x REAL,                     -- in the frame of the session [m]
    y REAL,
    yaw REAL,                   -- of compass east there [rad]
    session INTEGER,
    robot_x REAL,               -- where the robot stood, in the frame of the place [m]
    robot_y REAL,
    robot_yaw REAL,             -- [rad]
    learned_ns INTEGER,         -- since the epoch
    checksum INTEGER
  ))",
    R"(CREATE TABLE grid(
    place_id INTEGER PRIMARY KEY,
    cells BLOB,                 -- one signed byte a cell, row by row from the least y
    checksum INTEGER
  ))",
    R"(CREATE TABLE planes(
    id INTEGER PRIMARY KEY,     -- place_id / 16
    slots BLOB                  -- one of each place_id % 16: id, checksum, occupied, empty
  ))",
    R"(CREATE TABLE readings(
    place_id INTEGER PRIMARY KEY,
    readings BLOB,              -- of the scan from which the place was learned
    checksum INTEGER
  ))",
    R"(CREATE TABLE history(
    version INTEGER PRIMARY KEY,  -- of the map after the change
    stamp_ns INTEGER,             -- since the epoch
    change BLOB,
    checksum INTEGER
  ))",
    R"(CREATE TABLE node(
    id INTEGER PRIMARY KEY,     -- a scan that was taken while the robot drove: numbered as it drove
    session INTEGER,
    x REAL,                     -- of the base in the frame of the session [m]
    y REAL,
    yaw REAL,                   -- [rad]
    stamp_ns INTEGER,           -- since the epoch
    place_id INTEGER,           -- that it is; 0: none
    before INTEGER,             -- node that odometry came from; -1: none
    way BLOB,                   -- what odometry and compass measured: 11 doubles
    readings BLOB,              -- in the base's frame
    checksum INTEGER
  ))",
    R"(CREATE TABLE tie(
    id INTEGER PRIMARY KEY,
    place_node INTEGER,         -- node of a place
    node INTEGER,               -- that was matched to it
    x REAL,                     -- of the node in the place's base frame [m]
    y REAL,
    yaw REAL,                   -- [rad]
    information BLOB,           -- of that, row by row: 9 doubles
    closure INTEGER,            -- of which loop closure; 0: of none
    checksum INTEGER
  ))",
    R"(CREATE TABLE wheels(
    id INTEGER PRIMARY KEY,     -- 1: there is one row, or none
    bend REAL,                  -- turn that odometry misses [rad/m]
    turn_factor REAL,           -- share of its turns that it misses
    checksum INTEGER
  ))",
    R"(CREATE TABLE link(
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
    forward_habit BLOB,         -- what traversals and people taught: 6 doubles, whether forbidden;
    backward_habit BLOB,        -- empty, and then not in the checksum, in rows of format 4
    checksum INTEGER
  ))",
    R"(CREATE TABLE traversal(
    id INTEGER PRIMARY KEY,     -- rises
    from_id INTEGER,
    to_id INTEGER,
    begin_ns INTEGER,           -- since the epoch
    end_ns INTEGER,
    succeeded INTEGER,          -- 1, or 0
    source TEXT,                -- who said so
    checksum INTEGER
  ))",
};
// The first of those that are later than format 3, and than format 4.
constexpr std::size_t kSinceFormat4 = 6;
constexpr std::size_t kSinceFormat5 = 9;

std::vector<std::string> tablesOf(SqliteDatabase& database, const std::string& column,
                                  const std::string& order) {
  SqliteStatement query(database, "SELECT " + column +
                                      " FROM sqlite_master WHERE type = 'table' AND name NOT LIKE "
                                      "'sqlite_%' ORDER BY " +
                                      order);
  std::vector<std::string> tables;
  while (query.step()) tables.push_back(query.text(0));
  return tables;
}

}  // namespace

void createSchema(SqliteDatabase& database) {
  database.execute("PRAGMA page_size = 4096");
  SqliteTransaction transaction(database);
  for (const std::string& table : kTables) database.execute(table);
  database.execute("PRAGMA application_id = " + std::to_string(kStoreApplicationId));
  database.execute("PRAGMA user_version = " + std::to_string(kStoreFormat));
  transaction.commit();
}

void bringSchemaToFormat5(SqliteDatabase& database, std::uint32_t format) {
  if (format < 4) database.execute("DROP TABLE node");
  database.execute("ALTER TABLE link RENAME TO link_before");
  for (std::size_t i = format < 4 ? kSinceFormat4 : kSinceFormat5; i < kTables.size(); ++i) {
    database.execute(kTables[i]);
  }
  database.execute(
      "INSERT INTO link SELECT id, first_id, second_id, x, y, yaw, covariance, forward_succeeded, "
      "forward_failed, forward_last_ns, backward_succeeded, backward_failed, backward_last_ns, "
      "x'', x'', checksum FROM link_before; DROP TABLE link_before");
  database.execute("PRAGMA user_version = " + std::to_string(kStoreFormat));
}

void checkSchema(SqliteDatabase& database, std::uint32_t format) {
  bool sound = false;
  if (format == kStoreFormat) {
    sound = tablesOf(database, "sql", "rowid") == kTables;
  } else {
    std::vector<std::string> names{"grid", "link", "place"};
    if (format == 2) names.emplace_back("planes");
    if (format == 3) {
      names = {"grid", "history", "link", "node", "place", "planes", "readings", "store"};
    }
    if (format == 4) {
      names = {"grid",   "history",  "link",  "node", "place",
               "planes", "readings", "store", "tie",  "wheels"};
    }
    sound = tablesOf(database, "name", "name") == names;
  }
  if (!sound) {
    throwStoreError(database.path(), "is damaged: it has not the tables of format " +
                                         std::to_string(format) + "; it was left as it is");
  }
}

}  // namespace place_memory::core
