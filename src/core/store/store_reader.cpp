#include "core/store/store_reader.h"

#include <algorithm>

#include "core/map/place_label.h"
#include "core/store/plane_slots.h"
#include "core/store/store_rows.h"

namespace place_memory::core {
namespace {

/// How many places of a large store are gone through between two words on how far it has come.
constexpr std::size_t kPlacesBetweenReports = std::size_t{1} << 16U;

// More than a person reads.
constexpr std::size_t kMostSentences = 1000;

constexpr TableScan kPlaces{"place", "id", kPlaceColumns};
constexpr TableScan kLinks{"link", "id", kLinkColumns};
constexpr TableScan kGrids{"grid", "place_id", kGridColumns};
constexpr TableScan kPlanes{"planes", "id", "id, slots"};
constexpr TableScan kReadings{"readings", "place_id", kReadingsColumns};
constexpr TableScan kTraversals{"traversal", "id", kTraversalColumns};

std::string inWords(PlaceId id) { return "place " + std::to_string(id); }

std::uint64_t checksumAt(const SqliteStatement& row, int column) {
  return static_cast<std::uint64_t>(row.integer(column));
}

// What a damaged row still says, where it is the name of something.
std::string labelIn(const SqliteStatement& row) {
  const std::string label = row.text(2);
  return isValidLabel(label) ? " (label \"" + label + "\", if that is not damaged too)" : "";
}

}  // namespace

void Damages::add(const std::string& sentence) {
  if (sentence.empty() || sentences_.size() > kMostSentences) return;
  if (sentences_.size() == kMostSentences) {
    sentences_.emplace_back("and more");
  } else if (known_.insert(sentence).second) {
    sentences_.push_back(sentence);
  }
}

void StoreReader::meet(PlaceId id) {
  if (id < kPlaceIdLimit) highest_id_ = std::max(highest_id_, id);
}

void StoreReader::compare(StoreTable table, const TableFindings& found, const std::string& rows) {
  found_.of(table) = found.all;
  if (head_ != nullptr) damages_.add(compareTotals(head_->totals.of(table), found, rows));
}

StoreReader::Map StoreReader::readMap() {
  Map map;
  readPlaces(map);
  readLinks(map);
  return map;
}

void StoreReader::readPlaces(Map& map) {
  TableFindings found;
  std::unordered_set<std::string> labels;
  const auto refuse = [&](PlaceId id, const std::string& details) {
    ++found.bad;
    damages_.add(inWords(id) + " is damaged and was left out" + details);
  };
  scanTable(
      database_, kPlaces,
      [&](const SqliteStatement& row) {
        meet(row.integer(0));
        found.all.add(checksumAt(row, 11));
        std::optional<Place> place = readPlace(row);
        if (!place) {
          refuse(row.integer(0), labelIn(row));
        } else if (!labels.insert(place->label).second) {
          refuse(place->id, ": another one is called \"" + place->label + "\"");
        } else {
          map.places.push_back(std::move(*place));
        }
      },
      [&](std::int64_t id) {
        meet(id);
        found.all.add(0);
        refuse(id, "");
      });
  compare(StoreTable::kPlace, found, "places");
}

void StoreReader::readLinks(Map& map) {
  TableFindings found;
  const auto is_there = [&map](PlaceId id) {
    const auto at =
        std::lower_bound(map.places.begin(), map.places.end(), id,
                         [](const Place& place, PlaceId wanted) { return place.id < wanted; });
    return at != map.places.end() && at->id == id;
  };
  const auto refuse = [&](std::int64_t id) {
    ++found.bad;
    damages_.add("a link of place " + std::to_string(id >> kLinkShift) +
                 " is damaged and was left out");
  };
  scanTable(
      database_, kLinks,
      [&](const SqliteStatement& row) {
        found.all.add(checksumAt(row, kLinkChecksumColumn));
        const std::optional<LinkRow> link = readLink(row);
        if (!link) return refuse(row.integer(0));
        const PlaceLink& ends = link->link;
        meet(ends.second);
        if (is_there(ends.first) && is_there(ends.second)) {
          map.links.push_back(ends);
        } else {
          damages_.add("the link between the places " + std::to_string(ends.first) + " and " +
                       std::to_string(ends.second) + " was left out: one of them is not there");
        }
      },
      [&](std::int64_t id) {
        found.all.add(0);
        refuse(id);
      });
  compare(StoreTable::kLink, found, "links");
}

std::optional<EvidenceGrid> StoreReader::grid(PlaceId place) {
  SqliteStatement row(database_,
                      std::string("SELECT ") + kGridColumns + " FROM grid WHERE place_id = ?");
  try {
    if (row.bind(place).step()) return readGrid(row, cell_size_);
  } catch (const SqliteError& error) {
    if (error.code() != SQLITE_CORRUPT) throw;
  }
  return std::nullopt;
}

std::optional<std::vector<SonarReading>> StoreReader::readings(PlaceId place) {
  SqliteStatement row(
      database_, std::string("SELECT ") + kReadingsColumns + " FROM readings WHERE place_id = ?");
  try {
    if (!row.bind(place).step()) return std::vector<SonarReading>();
    return readReadings(row);
  } catch (const SqliteError& error) {
    if (error.code() != SQLITE_CORRUPT) throw;
    return std::nullopt;
  }
}

void StoreReader::give(PlaceId place, const std::optional<CellPlanes>& planes,
                       const std::function<void(PlaceId, const CellPlanes&)>& call) {
  if (planes && are_planes_trusted_) return call(place, *planes);
  const std::optional<EvidenceGrid> cells = grid(place);
  const std::string what = "the bit planes of " + inWords(place) + " are damaged";
  if (!planes)
    damages_.add(what + (cells ? ": made anew from its grid"
                               : ", and its grid is too: "
                                 "it is not recognized"));
  if (cells) return call(place, CellPlanes(*cells));
  if (planes) return call(place, *planes);
}

void StoreReader::forEachPlanes(const std::vector<PlaceId>& places, const StoreProgress& progress,
                                const std::function<void(PlaceId, const CellPlanes&)>& call) {
  TableFindings found;
  std::size_t next = 0;
  const auto give_next = [&](const std::optional<CellPlanes>& planes) {
    give(places[next++], planes, call);
    if (progress && next % kPlacesBetweenReports == 0) {
      progress("read " + std::to_string(next) + " places of the store");
    }
  };
  const auto give_before = [&](PlaceId id) {
    while (next < places.size() && places[next] < id) give_next(std::nullopt);
  };
  scanTable(
      database_, kPlanes,
      [&](const SqliteStatement& row) {
        const PlaceId first = row.integer(0) * kPlaneSlots;
        give_before(first);
        for (PlaceId id = first; id < first + kPlaneSlots; ++id) {
          const PlaneSlot slot(row.blob(1), row.size(1), id - first);
          const bool is_wanted = next < places.size() && places[next] == id;
          if (!slot.isEmpty()) found.all.add(slot.checksum());
          if (!slot.isEmpty()) meet(id);
          if (!is_wanted) continue;
          const std::optional<CellPlanes> planes = slot.planesOf(id);
          if (!planes) ++found.bad;
          give_next(planes);
        }
      },
      [&](std::int64_t row) { give_before((row + 1) * kPlaneSlots); });
  give_before(kPlaceIdLimit);
  const std::size_t before = damages_.sentences().size();
  compare(StoreTable::kPlanes, found, "bit planes");
  if (damages_.sentences().size() > before) are_planes_trusted_ = false;
}

void StoreReader::forEachGrid(const std::vector<PlaceId>& places,
                              const std::function<void(PlaceId, const EvidenceGrid&)>& call) {
  TableFindings found;
  std::size_t next = 0;
  const auto refuse = [&](PlaceId id) {
    ++found.bad;
    damages_.add("the grid of " + inWords(id) + " is damaged");
  };
  const auto miss_before = [&](PlaceId id) {
    for (; next < places.size() && places[next] < id; ++next) refuse(places[next]);
  };
  scanTable(
      database_, kGrids,
      [&](const SqliteStatement& row) {
        const PlaceId id = row.integer(0);
        meet(id);
        found.all.add(checksumAt(row, 2));
        miss_before(id);
        const std::optional<EvidenceGrid> cells = readGrid(row, cell_size_);
        if (!cells) refuse(id);
        if (next >= places.size() || places[next] != id) return;
        ++next;
        if (cells) call(id, *cells);
      },
      [&](std::int64_t id) {
        meet(id);
        found.all.add(0);
        miss_before(id);
        refuse(id);
        if (next < places.size() && places[next] == id) ++next;
      });
  miss_before(kPlaceIdLimit);
  compare(StoreTable::kGrid, found, "grids");
}

void StoreReader::checkReadings() {
  TableFindings found;
  const auto refuse = [&](PlaceId id) {
    ++found.bad;
    damages_.add("the readings of " + inWords(id) + " are damaged");
  };
  scanTable(
      database_, kReadings,
      [&](const SqliteStatement& row) {
        meet(row.integer(0));
        found.all.add(checksumAt(row, 2));
        if (!readReadings(row)) refuse(row.integer(0));
      },
      [&](std::int64_t id) {
        meet(id);
        found.all.add(0);
        refuse(id);
      });
  compare(StoreTable::kReadings, found, "scans' readings");
}

std::vector<Traversal> StoreReader::traversals() {
  std::vector<Traversal> traversals;
  TableFindings found;
  scanTable(
      database_, kTraversals,
      [&](const SqliteStatement& row) {
        found.all.add(checksumAt(row, 7));
        if (std::optional<Traversal> traversal = readTraversal(row)) {
          traversals.push_back(std::move(*traversal));
        } else {
          ++found.bad;
        }
      },
      [&](std::int64_t /*unreadable*/) {
        found.all.add(0);
        ++found.bad;
      });
  if (found.bad > 0) {
    damages_.add(std::to_string(found.bad) + " traversals of links are damaged and were left out");
  }
  compare(StoreTable::kTraversal, found, "traversals of links");
  return traversals;
}

}  // namespace place_memory::core
