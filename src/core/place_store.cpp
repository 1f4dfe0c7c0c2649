#include "place_memory/core/place_store.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <cstring>
#include <utility>

#include "place_memory/core/place_label.h"
#include "sqlite.h"
#include "store_file.h"

namespace place_memory::core {
namespace {

// Cell sizes that went through text, as in a YAML file, may differ in the last digits.
constexpr double kCellSizeTolerance = 1e-9;

std::int64_t checksum(const void* cells) {
  boost::crc_32_type crc;
  crc.process_bytes(cells, kGridCells);
  return crc.checksum();
}

void checkCellSize(SqliteDatabase& database, double cell_size) {
  SqliteStatement query(database,
                        "SELECT cell_size FROM grid WHERE abs(cell_size - ?) > ? LIMIT 1");
  query.bind(cell_size).bind(kCellSizeTolerance);
  if (query.step()) {
    throwStoreError(database.path(), "its grids have cells of " + std::to_string(query.real(0)) +
                                         " m, but " + std::to_string(cell_size) +
                                         " m are configured. Set that cell size, or name another "
                                         "file");
  }
}

void readPlaces(SqliteDatabase& database, PlaceGraph* graph) {
  SqliteStatement row(database, "SELECT id, label, x, y, yaw, learned_ns FROM place");
  while (row.step()) {
    const Place place{row.integer(0),
                      row.text(1),
                      {row.real(2), row.real(3), row.real(4)},
                      std::chrono::nanoseconds(row.integer(5))};
    if (!isValidLabel(place.label) || !place.map_from_place.isFinite()) {
      throw std::invalid_argument("place " + std::to_string(place.id) +
                                  " has no valid label or location");
    }
    graph->add(place);
  }
}

void readLinks(SqliteDatabase& database, PlaceGraph* graph) {
  SqliteStatement row(database, "SELECT first_id, second_id FROM link");
  while (row.step()) graph->link(row.integer(0), row.integer(1));
}

// The columns checksum and cells, from `column` on.
EvidenceGrid readGrid(const SqliteDatabase& database, const SqliteStatement& row, int column,
                      double cell_size) {
  EvidenceGrid grid(GridGeometry{cell_size});
  const void* cells = row.blob(column + 1);
  if (row.size(column + 1) != kGridCells || checksum(cells) != row.integer(column)) {
    throwStoreError(database.path(), "is damaged: a grid is not as it was written");
  }
  std::memcpy(grid.cells().data(), cells, kGridCells);
  return grid;
}

void insertLink(SqliteDatabase& database, PlaceId one, PlaceId other) {
  SqliteStatement insert(database, "INSERT OR IGNORE INTO link VALUES(?, ?)");
  insert.bind(std::min(one, other)).bind(std::max(one, other)).run();
}

}  // namespace

PlaceStore::PlaceStore(const std::string& path, double cell_size)
    : database_(openStoreFile(path)), cell_size_(cell_size) {
  checkCellSize(*database_, cell_size);
}

PlaceStore::~PlaceStore() = default;
PlaceStore::PlaceStore(PlaceStore&&) noexcept = default;
PlaceStore& PlaceStore::operator=(PlaceStore&&) noexcept = default;

PlaceGraph PlaceStore::graph() const {
  PlaceGraph graph;
  try {
    readPlaces(*database_, &graph);
    readLinks(*database_, &graph);
  } catch (const std::invalid_argument& error) {
    throwStoreError(database_->path(), std::string("is damaged: ") + error.what());
  }
  return graph;
}

EvidenceGrid PlaceStore::grid(PlaceId id) const {
  SqliteStatement query(*database_, "SELECT checksum, cells FROM grid WHERE place_id = ?");
  if (!query.bind(id).step()) {
    throwStoreError(database_->path(), "has no place " + std::to_string(id));
  }
  return readGrid(*database_, query, 0, cell_size_);
}

void PlaceStore::forEachGrid(const std::function<void(PlaceId, const EvidenceGrid&)>& call) const {
  SqliteStatement query(*database_, "SELECT place_id, checksum, cells FROM grid ORDER BY place_id");
  while (query.step()) call(query.integer(0), readGrid(*database_, query, 1, cell_size_));
}

PlaceId PlaceStore::add(const Place& place, const EvidenceGrid& grid, PlaceId came_from) {
  SqliteTransaction transaction(*database_);
  SqliteStatement(*database_,
                  "INSERT INTO place(label, x, y, yaw, learned_ns) VALUES(?, ?, ?, ?, ?)")
      .bind(place.label)
      .bind(place.map_from_place.x)
      .bind(place.map_from_place.y)
      .bind(place.map_from_place.yaw)
      .bind(place.learned.count())
      .run();
  const PlaceId id = sqlite3_last_insert_rowid(database_->handle());
  SqliteStatement(*database_, "INSERT INTO grid VALUES(?, ?, ?, ?)")
      .bind(id)
      .bind(grid.geometry().cell_size)
      .bind(checksum(grid.cells().data()))
      .bind(grid.cells().data(), grid.cells().size())
      .run();
  if (came_from != kNoPlace) insertLink(*database_, came_from, id);
  transaction.commit();
  return id;
}

void PlaceStore::rename(PlaceId id, const std::string& label) {
  SqliteTransaction transaction(*database_);
  SqliteStatement(*database_, "UPDATE place SET label = ? WHERE id = ?").bind(label).bind(id).run();
  transaction.commit();
}

void PlaceStore::update(PlaceId id, const EvidenceGrid& grid) {
  SqliteTransaction transaction(*database_);
  SqliteStatement(*database_, "UPDATE grid SET checksum = ?, cells = ? WHERE place_id = ?")
      .bind(checksum(grid.cells().data()))
      .bind(grid.cells().data(), grid.cells().size())
      .bind(id)
      .run();
  if (sqlite3_changes(database_->handle()) == 0) {
    throwStoreError(database_->path(), "has no place " + std::to_string(id));
  }
  transaction.commit();
}

void PlaceStore::remove(PlaceId id) {
  SqliteTransaction transaction(*database_);
  SqliteStatement(*database_, "DELETE FROM place WHERE id = ?").bind(id).run();
  transaction.commit();
}

void PlaceStore::clear() {
  SqliteTransaction transaction(*database_);
  database_->execute("DELETE FROM place");
  transaction.commit();
}

}  // namespace place_memory::core
