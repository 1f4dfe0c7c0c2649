#include "core/store/old_store.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/map/place_label.h"
#include "core/store/row_checksum.h"

namespace place_memory::core {
namespace {

// Cell sizes that went through text, as in a YAML file, may differ in the last digits.
constexpr double kCellSizeTolerance = 1e-9;

// Some megabytes of grids.
constexpr std::size_t kPlacesAtOnce = 1000;

[[noreturn]] void refuse(const SqliteDatabase& database, const std::string& what) {
  throwStoreError(database.path(), "is damaged: " + what);
}

EvidenceGrid readCells(const SqliteDatabase& database, const SqliteStatement& row, int column,
                       double cell_size) {
  const void* cells = row.blob(column + 1);
  boost::crc_32_type crc;
  if (row.size(column + 1) == kGridCells) crc.process_bytes(cells, kGridCells);
  if (row.size(column + 1) != kGridCells || crc.checksum() != row.integer(column)) {
    refuse(database, "the grid of place " + std::to_string(row.integer(0)) + " is not as written");
  }
  EvidenceGrid grid(GridGeometry{cell_size});
  std::memcpy(grid.cells().data(), cells, kGridCells);
  return grid;
}

// Two copies of a store give a place the same one.
PlaceIdentity identityOf(const Place& place, const EvidenceGrid& grid) {
  PlaceIdentity identity{};
  for (std::size_t half = 0; half < 2; ++half) {
    std::uint64_t bits = RowChecksum(0x9e3779b97f4a7c15U * (half + 1))
                             .add(place.id)
                             .add(std::int64_t{place.learned.count()})
                             .add(place.map_from_place)
                             .add(grid.cells().data(), grid.cells().size())
                             .value();
    bits = (bits ^ bits >> 30U) * 0xbf58476d1ce4e5b9U;  // splitmix64: every bit from every other
    bits = (bits ^ bits >> 27U) * 0x94d049bb133111ebU;
    bits ^= bits >> 31U;
    for (std::size_t i = 0; i < 8; ++i) {
      identity[8 * half + i] = static_cast<std::uint8_t>(bits >> 8 * i & 0xffU);
    }
  }
  return identity;
}

Place readPlace(const SqliteDatabase& database, const SqliteStatement& row) {
  Place place;
  place.id = row.integer(0);
  place.label = row.text(1);
  place.map_from_place = {row.real(2), row.real(3), row.real(4)};
  place.learned = std::chrono::nanoseconds(row.integer(5));
  if (place.id <= kNoPlace || !isValidLabel(place.label) || !place.map_from_place.isFinite()) {
    refuse(database, "place " + std::to_string(place.id) + " has no valid id, label or location");
  }
  return place;
}

// It was not kept how the robot went: that the places lie where the map says is all there is.
PlaceLink makeLink(const Pose2d& first, const Pose2d& second) {
  PlaceLink link;
  link.first_from_second = first.inverse() * second;
  for (std::size_t i = 0; i < 3; ++i) link.covariance[4 * i] = kUnknownVariance;
  return link;
}

class Changes {
 public:
  explicit Changes(const std::function<void(const MapChange&)>& call) : call_(call) {}

  void add(MapEdit edit, std::chrono::nanoseconds stamp) {
    change_.stamp = std::max(change_.stamp, stamp);
    change_.edits.push_back(std::move(edit));
    if (change_.edits.size() == kPlacesAtOnce) flush();
  }
  void flush() {
    if (change_.edits.empty()) return;
    ++change_.version;
    call_(change_);
    change_.edits.clear();
  }

 private:
  const std::function<void(const MapChange&)>& call_;
  MapChange change_;
};

}  // namespace

void checkOldStore(SqliteDatabase& database, double cell_size) {
  SqliteStatement query(database,
                        "SELECT cell_size FROM grid WHERE NOT abs(cell_size - ?) <= ? LIMIT 1");
  if (query.bind(cell_size).bind(kCellSizeTolerance).step()) {
    throwStoreError(database.path(), "its grids have cells of " + std::to_string(query.real(0)) +
                                         " m, but " + std::to_string(cell_size) +
                                         " m are configured. Set that cell size, or name another "
                                         "file");
  }
  if (SqliteStatement(database, "PRAGMA foreign_key_check").step() ||
      SqliteStatement(database, "SELECT id FROM place WHERE id NOT IN (SELECT place_id FROM grid)")
          .step()) {
    refuse(database, "places, grids and links do not belong together");
  }
}

PlaceId oldNextId(SqliteDatabase& database) {
  SqliteStatement row(database, "SELECT seq FROM sqlite_sequence WHERE name = 'place'");
  return row.step() ? row.integer(0) + 1 : 1;
}

void readOldStore(SqliteDatabase& database, double cell_size,
                  const std::function<void(const MapChange&)>& call) {
  Changes changes(call);
  std::unordered_map<PlaceId, Pose2d> poses;
  SqliteStatement row(database,
                      "SELECT id, label, x, y, yaw, learned_ns, checksum, cells FROM place "
                      "JOIN grid ON place_id = id ORDER BY id");
  while (row.step()) {
    Place place = readPlace(database, row);
    auto grid = std::make_shared<EvidenceGrid>(readCells(database, row, 6, cell_size));
    place.identity = identityOf(place, *grid);
    poses[place.id] = place.map_from_place;
    const std::chrono::nanoseconds stamp = place.learned;
    changes.add(PlaceAdded{std::move(place), std::move(grid), nullptr}, stamp);
  }
  SqliteStatement ends(database, "SELECT first_id, second_id FROM link");
  while (ends.step()) {
    const PlaceId first = ends.integer(0);
    const PlaceId second = ends.integer(1);
    if (first >= second || poses.count(first) == 0 || poses.count(second) == 0) {
      refuse(database, "a link leads to no place");
    }
    PlaceLink link = makeLink(poses[first], poses[second]);
    link.first = first;
    link.second = second;
    changes.add(LinkAdded{link}, std::chrono::nanoseconds(0));
  }
  changes.flush();
}

}  // namespace place_memory::core
