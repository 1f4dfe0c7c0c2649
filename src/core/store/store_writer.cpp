#include "core/store/store_writer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/map/place_label.h"
#include "core/store/table_scan.h"

namespace place_memory::core {
namespace {

// Some 60 MB of history.
constexpr std::int64_t kMostTraversals = 1000000;

std::string replaceInto(const std::string& table, int columns) {
  std::string sql = "REPLACE INTO " + table + " VALUES(?";
  for (int i = 1; i < columns; ++i) sql += ", ?";
  return sql + ")";
}

}  // namespace

void LabelHashes::remove(const std::string& label) {
  const auto found = counts_.find(std::hash<std::string>()(label));
  if (found != counts_.end() && --found->second == 0) counts_.erase(found);
}

CountedTable::CountedTable(SqliteDatabase& database, const std::string& name,
                           const std::string& key, int columns, TableTotal& total)
    : find_(database, "SELECT checksum FROM " + name + " WHERE " + key + " = ?"),
      replace_(database, replaceInto(name, columns)),
      remove_(database, "DELETE FROM " + name + " WHERE " + key + " = ?"),
      total_(total) {}

bool CountedTable::has(std::int64_t id) {
  bool has = true;
  try {
    has = find_.bind(id).step();
  } catch (const SqliteError& error) {
    if (error.code() != SQLITE_CORRUPT) throw;  // a row that cannot be made out is one
  }
  find_.reset();
  return has;
}

SqliteStatement& CountedTable::replace(std::int64_t id) {
  forget(id);
  return replace_;
}

bool CountedTable::holds(std::int64_t id, std::uint64_t checksum) {
  const bool holds =
      find_.bind(id).step() && static_cast<std::uint64_t>(find_.integer(0)) == checksum;
  find_.reset();
  return holds;
}

bool CountedTable::remove(std::int64_t id) {
  if (!forget(id)) return false;
  remove_.bind(id).run();
  return true;
}

bool CountedTable::forget(std::int64_t id) {
  std::optional<std::uint64_t> checksum;
  try {
    if (find_.bind(id).step()) checksum = static_cast<std::uint64_t>(find_.integer(0));
  } catch (const SqliteError& error) {
    if (error.code() != SQLITE_CORRUPT) throw;
    checksum = 0;
  }
  find_.reset();
  if (checksum) total_.remove(*checksum);
  return checksum.has_value();
}

StoreWriter::StoreWriter(SqliteDatabase& database, StoreHead& head, LabelHashes& labels)
    : database_(database),
      head_(head),
      labels_(labels),
      places_(database, "place", "id", 12, head.totals.of(StoreTable::kPlace)),
      links_(database, "link", "id", 16, head.totals.of(StoreTable::kLink)),
      grids_(database, "grid", "place_id", 3, head.totals.of(StoreTable::kGrid)),
      readings_(database, "readings", "place_id", 3, head.totals.of(StoreTable::kReadings)),
      traversals_(database, "traversal", "id", 8, head.totals.of(StoreTable::kTraversal)),
      planes_(database, head.totals.of(StoreTable::kPlanes)),
      read_place_(database, std::string("SELECT ") + kPlaceColumns + " FROM place WHERE id = ?"),
      find_link_(database, std::string("SELECT ") + kLinkColumns +
                               " FROM link WHERE id >= ? AND id < ? AND second_id = ?"),
      last_link_(database, "SELECT max(id) FROM link WHERE id >= ? AND id < ?"),
      last_traversal_(database, "SELECT max(id) FROM traversal") {}

void StoreWriter::refuse(const std::string& why) const { throwStoreError(database_.path(), why); }

Place StoreWriter::read(PlaceId id) {
  std::optional<Place> place;
  const bool is_there = read_place_.bind(id).step();
  if (is_there) place = readPlace(read_place_);
  read_place_.reset();
  if (!is_there) refuse("has no place " + std::to_string(id));
  if (!place) refuse("is damaged: place " + std::to_string(id) + " is not as it was written");
  return *place;
}

void StoreWriter::write(const Place& place) {
  places_.add(writePlace(places_.replace(place.id), place));
}

void StoreWriter::writeGridOf(PlaceId id, const EvidenceGrid* grid) {
  if (grid == nullptr) refuse("place " + std::to_string(id) + " has no grid");
  grids_.add(writeGrid(grids_.replace(id), id, *grid));
  planes_.put(id, CellPlanes(*grid));
}

void StoreWriter::claim(const std::string& label, PlaceId id) {
  if (!isValidLabel(label)) refuse("the label of place " + std::to_string(id) + " is no label");
  if (labels_.mayHave(label)) {
    scanTable(
        database_, {"place", "id", "id, label"},
        [&](const SqliteStatement& row) {
          if (row.text(1) == label && row.integer(0) != id) {
            refuse("has a place \"" + label + "\" already");
          }
        },
        [](std::int64_t /*unreadable*/) {});
  }
  labels_.add(label);
}

void StoreWriter::operator()(const PlaceAdded& edit) {
  const Place& place = edit.place;
  if (place.id <= kNoPlace || place.id >= kPlaceIdLimit || place.session <= kNoSession ||
      !place.map_from_place.isFinite() || !place.place_from_robot.isFinite()) {
    refuse("place " + std::to_string(place.id) + " cannot be written: it is not a place");
  }
  if (place.id < head_.next_place && places_.has(place.id)) {
    refuse("has a place " + std::to_string(place.id) + " already");
  }
  if (removed_.count(place.id) > 0) removeLinksOfRemoved();
  claim(place.label, place.id);
  write(place);
  writeGridOf(place.id, edit.grid.get());
  if (edit.readings != nullptr && !edit.readings->empty()) {
    readings_.add(writeReadings(readings_.replace(place.id), place.id, *edit.readings));
  }
  head_.next_place = std::max(head_.next_place, place.id + 1);
  head_.next_session = std::max(head_.next_session, place.session + 1);
}

void StoreWriter::operator()(const PlaceMoved& edit) {
  Place place = read(edit.id);
  place.map_from_place = edit.map_from_place;
  place.session = edit.session;
  if (!place.map_from_place.isFinite() || place.session <= kNoSession) {
    refuse("place " + std::to_string(place.id) + " cannot lie there");
  }
  write(place);
  head_.next_session = std::max(head_.next_session, place.session + 1);
}

void StoreWriter::operator()(const PlaceRenamed& edit) {
  Place place = read(edit.id);
  if (place.label == edit.label) return;
  claim(edit.label, edit.id);
  labels_.remove(place.label);
  place.label = edit.label;
  write(place);
}

void StoreWriter::operator()(const GridAdapted& edit) {
  if (!places_.has(edit.id)) refuse("has no place " + std::to_string(edit.id));
  writeGridOf(edit.id, edit.grid.get());
}

void StoreWriter::operator()(const PlaceRemoved& edit) {
  labels_.remove(read(edit.id).label);
  places_.remove(edit.id);
  grids_.remove(edit.id);
  readings_.remove(edit.id);
  planes_.remove(edit.id);
  removed_.insert(edit.id);
}

std::optional<std::int64_t> StoreWriter::findLink(PlaceId first, PlaceId second,
                                                  std::optional<LinkRow>& link) {
  find_link_.bind(first << kLinkShift).bind((first + 1) << kLinkShift).bind(second);
  std::optional<std::int64_t> id;
  if (find_link_.step()) {
    id = find_link_.integer(0);
    link = readLink(find_link_);
  }
  find_link_.reset();
  return id;
}

std::int64_t StoreWriter::newLinkId(PlaceId first) {
  last_link_.bind(first << kLinkShift).bind((first + 1) << kLinkShift).step();
  const std::int64_t last = last_link_.integer(0);  // 0 where there is none
  last_link_.reset();
  const std::int64_t next = std::max(last + 1, first << kLinkShift);
  if (next >> kLinkShift != first) {
    refuse("place " + std::to_string(first) + " has too many links");
  }
  return next;
}

void StoreWriter::write(const LinkRow& row) { links_.add(writeLink(links_.replace(row.id), row)); }

void StoreWriter::write(const std::optional<Traversal>& traversal) {
  if (!traversal) return;
  last_traversal_.step();
  const std::int64_t id = last_traversal_.integer(0) + 1;  // 0 where there is none
  last_traversal_.reset();
  traversals_.add(writeTraversal(traversals_.replace(id), id, *traversal));
  traversals_.remove(id - kMostTraversals);
}

void StoreWriter::operator()(const LinkAdded& edit) {
  const PlaceLink& link = edit.link;
  if (!(link.first < link.second) || !places_.has(link.first) || !places_.has(link.second)) {
    refuse("has no places " + std::to_string(link.first) + " and " + std::to_string(link.second) +
           " to link");
  }
  std::optional<LinkRow> before;
  const std::optional<std::int64_t> id = findLink(link.first, link.second, before);
  write(LinkRow{id ? *id : newLinkId(link.first), link});
  write(edit.traversal);
}

void StoreWriter::operator()(const LinkRemoved& edit) {
  const auto [first, second] = std::minmax(edit.first, edit.second);
  std::optional<LinkRow> link;
  const std::optional<std::int64_t> id = findLink(first, second, link);
  if (!id)
    refuse("has no link between " + std::to_string(first) + " and " + std::to_string(second));
  links_.remove(*id);
}

void StoreWriter::operator()(const LinkLearned& edit) {
  const auto [first, second] = std::minmax(edit.from, edit.to);
  std::optional<LinkRow> row;
  findLink(first, second, row);
  if (!row)
    refuse("has no link between " + std::to_string(first) + " and " + std::to_string(second));
  (edit.from == first ? row->link.forward : row->link.backward) = edit.direction;
  write(*row);
  write(edit.traversal);
}

void StoreWriter::operator()(const MapCleared& /*edit*/) {
  for (const char* table : {"place", "link", "grid", "planes", "readings", "node", "history", "tie",
                            "wheels", "traversal"}) {
    database_.execute(std::string("DELETE FROM ") + table);
  }
  planes_.close();
  head_.totals = StoreTotals();
  labels_.clear();
  removed_.clear();
}

void StoreWriter::finish() {
  if (!removed_.empty()) removeLinksOfRemoved();
  planes_.close();
}

// Of the second place of a link nothing leads to the row, so one pass through all of them stands at
// the end of a change, however many places it removes.
void StoreWriter::removeLinksOfRemoved() {
  std::vector<std::int64_t> rows;
  scanTable(
      database_, {"link", "id", "id, first_id, second_id"},
      [&](const SqliteStatement& row) {
        if (removed_.count(row.integer(1)) > 0 || removed_.count(row.integer(2)) > 0) {
          rows.push_back(row.integer(0));
        }
      },
      [](std::int64_t /*unreadable*/) {});
  for (const std::int64_t row : rows) links_.remove(row);
  removed_.clear();
}

}  // namespace place_memory::core
