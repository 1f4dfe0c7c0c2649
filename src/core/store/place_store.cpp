#include "core/store/place_store.h"

#include <algorithm>
#include <utility>

#include "core/store/sqlite.h"
#include "core/store/store_file.h"
#include "core/store/store_migration.h"
#include "core/store/store_rows.h"

namespace place_memory::core {
namespace {

// Cell sizes that went through text, as in a YAML file, may differ in the last digits.
constexpr double kCellSizeTolerance = 1e-9;

// In a store that was not checked in full, one grid stands for all: they are written by one rule.
void checkCellSize(SqliteDatabase& database, double cell_size, bool of_all) {
  const std::string source = of_all ? "grid" : "(SELECT cell_size FROM grid LIMIT 1)";
  SqliteStatement query(
      database, "SELECT cell_size FROM " + source + " WHERE abs(cell_size - ?) > ? LIMIT 1");
  query.bind(cell_size).bind(kCellSizeTolerance);
  if (query.step()) {
    throwStoreError(database.path(), "its grids have cells of " + std::to_string(query.real(0)) +
                                         " m, but " + std::to_string(cell_size) +
                                         " m are configured. Set that cell size, or name another "
                                         "file");
  }
}

std::vector<Place> readPlaces(SqliteDatabase& database) {
  std::vector<Place> places;
  SqliteStatement row(database, "SELECT id, label, x, y, yaw, learned_ns FROM place ORDER BY id");
  while (row.step()) {
    Place& place = places.emplace_back();
    place.id = row.integer(0);
    place.label = row.text(1);
    place.map_from_place = {row.real(2), row.real(3), row.real(4)};
    place.learned = std::chrono::nanoseconds(row.integer(5));
  }
  return places;
}

std::vector<PlaceLink> readLinks(SqliteDatabase& database) {
  std::vector<PlaceLink> links;
  SqliteStatement row(database, "SELECT first_id, second_id FROM link");
  while (row.step()) {
    PlaceLink& link = links.emplace_back();
    link.first = row.integer(0);
    link.second = row.integer(1);
  }
  return links;
}

void insertLink(SqliteDatabase& database, PlaceId one, PlaceId other) {
  SqliteStatement insert(database, "INSERT OR IGNORE INTO link VALUES(?, ?)");
  insert.bind(std::min(one, other)).bind(std::max(one, other)).run();
}

/// Writes edits into the tables.
class RowEditor {
 public:
  explicit RowEditor(SqliteDatabase& database) : database_(database) {}

  void operator()(const PlaceAdded& edit) {
    const Place& place = edit.place;
    SqliteStatement(database_, "INSERT INTO place VALUES(?, ?, ?, ?, ?, ?)")
        .bind(place.id)
        .bind(place.label)
        .bind(place.map_from_place.x)
        .bind(place.map_from_place.y)
        .bind(place.map_from_place.yaw)
        .bind(place.learned.count())
        .run();
    insertGrid(database_, place.id, *edit.grid);
    insertPlanes(database_, place.id, CellPlanes(*edit.grid));
  }
  void operator()(const PlaceMoved& edit) {
    SqliteStatement(database_, "UPDATE place SET x = ?, y = ?, yaw = ? WHERE id = ?")
        .bind(edit.map_from_place.x)
        .bind(edit.map_from_place.y)
        .bind(edit.map_from_place.yaw)
        .bind(edit.id)
        .run();
  }
  void operator()(const PlaceRenamed& edit) {
    SqliteStatement(database_, "UPDATE place SET label = ? WHERE id = ?")
        .bind(edit.label)
        .bind(edit.id)
        .run();
  }
  void operator()(const GridAdapted& edit) { updateGrid(database_, edit.id, *edit.grid); }
  void operator()(const PlaceRemoved& edit) {
    SqliteStatement(database_, "DELETE FROM place WHERE id = ?").bind(edit.id).run();
  }
  void operator()(const LinkAdded& edit) {
    insertLink(database_, edit.link.first, edit.link.second);
  }
  void operator()(const LinkRemoved& edit) {
    SqliteStatement(database_, "DELETE FROM link WHERE first_id = ? AND second_id = ?")
        .bind(std::min(edit.first, edit.second))
        .bind(std::max(edit.first, edit.second))
        .run();
  }
  void operator()(const LinkLearned& /*edit*/) {}
  void operator()(const MapCleared& /*edit*/) { database_.execute("DELETE FROM place"); }

 private:
  SqliteDatabase& database_;
};

}  // namespace

PlaceStore::PlaceStore(const std::string& path, double cell_size, const StoreOpening& opening)
    : cell_size_(cell_size), progress_(opening.progress) {
  StoreFile file = openStoreFile(path, opening);
  database_ = std::move(file.database);
  checkCellSize(*database_, cell_size, file.checked);
  if (file.old) addPlanesToStore(*database_, progress_);
}

PlaceStore::~PlaceStore() = default;
PlaceStore::PlaceStore(PlaceStore&&) noexcept = default;
PlaceStore& PlaceStore::operator=(PlaceStore&&) noexcept = default;

PlaceMap PlaceStore::map() const {
  try {
    return PlaceMap(readPlaces(*database_), readLinks(*database_), 0, {});
  } catch (const std::invalid_argument& error) {
    throwStoreError(database_->path(), std::string("is damaged: ") + error.what());
  }
}

PlaceId PlaceStore::nextId() const {
  SqliteStatement query(*database_, "SELECT seq FROM sqlite_sequence WHERE name = 'place'");
  return query.step() ? query.integer(0) + 1 : kNoPlace + 1;
}

SessionId PlaceStore::nextSession() const { return nextId() > 1 ? 2 : kFirstSession; }

void PlaceStore::commit(const MapChange& change) {
  SqliteTransaction transaction(*database_);
  RowEditor editor(*database_);
  for (const MapEdit& edit : change.edits) std::visit(editor, edit);
  transaction.commit();
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

void PlaceStore::forEachPlanes(const std::function<void(PlaceId, const CellPlanes&)>& call) const {
  // A place whose row is not there comes with an empty one, which is refused.
  SqliteStatement query(*database_,
                        "SELECT id, checksum, cells FROM place LEFT JOIN planes ON place_id = id "
                        "ORDER BY id");
  std::size_t places = 0;
  while (query.step()) {
    call(query.integer(0), readPlanes(*database_, query, 1));
    if (progress_ && ++places % kPlacesBetweenReports == 0) {
      progress_("read " + std::to_string(places) + " places of the store");
    }
  }
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
  insertGrid(*database_, id, grid);
  insertPlanes(*database_, id, CellPlanes(grid));
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
  if (!updateGrid(*database_, id, grid)) {
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

void PlaceStore::atOnce(const std::function<void()>& changes) {
  SqliteTransaction transaction(*database_);
  changes();
  transaction.commit();
}

}  // namespace place_memory::core
