#ifndef PLACE_MEMORY_CORE_STORE_STORE_ROWS_H
#define PLACE_MEMORY_CORE_STORE_STORE_ROWS_H

#include <cstdint>
#include <optional>
#include <vector>

#include "core/store/sqlite.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/sonar_reading.h"

namespace place_memory::core {

// How places, links, grids and readings lie in the rows of their tables. What is written returns
// the row's checksum. What is read is nothing where the row is not as it was written, or says what
// no map can hold.

/// Ids are lower: their links lie in rows by id << kLinkShift.
constexpr PlaceId kPlaceIdLimit = PlaceId{1} << 42U;
constexpr unsigned kLinkShift = 20;

inline constexpr char kPlaceColumns[] =
    "id, identity, label, x, y, yaw, session, robot_x, robot_y, robot_yaw, learned_ns, checksum";
inline constexpr char kLinkColumns[] =
    "id, first_id, second_id, x, y, yaw, covariance, forward_succeeded, forward_failed, "
    "forward_last_ns, backward_succeeded, backward_failed, backward_last_ns, forward_habit, "
    "backward_habit, checksum";
constexpr int kLinkChecksumColumn = 15;
inline constexpr char kGridColumns[] = "place_id, cells, checksum";
inline constexpr char kReadingsColumns[] = "place_id, readings, checksum";
inline constexpr char kTraversalColumns[] =
    "id, from_id, to_id, begin_ns, end_ns, succeeded, source, checksum";

struct LinkRow {
  std::int64_t id = 0;
  PlaceLink link;
};

// `insert` is a statement "REPLACE INTO place VALUES(?, ...)" and so on, with all columns.
std::uint64_t writePlace(SqliteStatement& insert, const Place& place);
std::uint64_t writeLink(SqliteStatement& insert, const LinkRow& row);
std::uint64_t writeGrid(SqliteStatement& insert, PlaceId place, const EvidenceGrid& grid);
std::uint64_t writeReadings(SqliteStatement& insert, PlaceId place,
                            const std::vector<SonarReading>& readings);
std::uint64_t writeTraversal(SqliteStatement& insert, std::int64_t id, const Traversal& traversal);

// `row` stands on a row with all columns, in the order in which they are named above.
std::optional<Place> readPlace(const SqliteStatement& row);
std::optional<LinkRow> readLink(const SqliteStatement& row);
std::optional<EvidenceGrid> readGrid(const SqliteStatement& row, double cell_size);
std::optional<std::vector<SonarReading>> readReadings(const SqliteStatement& row);
std::optional<Traversal> readTraversal(const SqliteStatement& row);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_ROWS_H
