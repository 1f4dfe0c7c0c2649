#ifndef PLACE_MEMORY_CORE_STORE_STORE_READER_H
#define PLACE_MEMORY_CORE_STORE_STORE_READER_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/grid/cell_planes.h"
#include "core/store/sqlite.h"
#include "core/store/store_head.h"
#include "core/store/table_scan.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/sonar_reading.h"
#include "place_memory/core/store_opening.h"

namespace place_memory::core {

/// What is damaged in a store: a sentence each, none twice.
class Damages {
 public:
  void add(const std::string& sentence);
  const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  std::vector<std::string> sentences_;
  std::unordered_set<std::string> known_;
};

/// Reads the tables of places. Rows that are not as they were written are left out and named.
class StoreReader {
 public:
  /// `head` is nothing where it is damaged: totals are not compared then.
  StoreReader(SqliteDatabase& database, double cell_size, const StoreHead* head, Damages& damages)
      : database_(database), cell_size_(cell_size), head_(head), damages_(damages) {}

  struct Map {
    std::vector<Place> places;
    std::vector<PlaceLink> links;
  };
  Map readMap();

  /// Nothing, and nothing said, where there is no such row or it is damaged.
  std::optional<EvidenceGrid> grid(PlaceId place);
  /// Nothing where they are damaged; empty where there are none.
  std::optional<std::vector<SonarReading>> readings(PlaceId place);

  /// Calls with the bit planes of each place, from its grid where they are damaged. `places` rise.
  void forEachPlanes(const std::vector<PlaceId>& places, const StoreProgress& progress,
                     const std::function<void(PlaceId, const CellPlanes&)>& call);
  /// Likewise.
  void forEachGrid(const std::vector<PlaceId>& places,
                   const std::function<void(PlaceId, const EvidenceGrid&)>& call);
  void checkReadings();
  /// The oldest first.
  std::vector<Traversal> traversals();

  /// Of the tables that were read to their end.
  const StoreTotals& found() const { return found_; }
  /// Highest id that stands anywhere in what was read, damaged or not.
  PlaceId highestId() const { return highest_id_; }
  /// False where they are not those that were written last, though each is sound.
  bool arePlanesTrusted() const { return are_planes_trusted_; }
  void distrustPlanes() { are_planes_trusted_ = false; }

 private:
  void readPlaces(Map& map);
  void readLinks(Map& map);
  void give(PlaceId place, const std::optional<CellPlanes>& planes,
            const std::function<void(PlaceId, const CellPlanes&)>& call);
  void compare(StoreTable table, const TableFindings& found, const std::string& rows);
  void meet(PlaceId id);

  SqliteDatabase& database_;
  double cell_size_;
  const StoreHead* head_;
  Damages& damages_;
  StoreTotals found_;
  PlaceId highest_id_ = kNoPlace;
  bool are_planes_trusted_ = true;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_READER_H
