#ifndef PLACE_MEMORY_CORE_STORE_STORE_WRITER_H
#define PLACE_MEMORY_CORE_STORE_STORE_WRITER_H

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "core/store/plane_slots.h"
#include "core/store/sqlite.h"
#include "core/store/store_head.h"
#include "core/store/store_rows.h"
#include "place_memory/core/map_change.h"

namespace place_memory::core {

/// Which labels are taken, by hash: 1 says perhaps, 0 surely not.
class LabelHashes {
 public:
  void add(const std::string& label) { ++counts_[std::hash<std::string>()(label)]; }
  void remove(const std::string& label);
  bool mayHave(const std::string& label) const {
    return counts_.count(std::hash<std::string>()(label)) > 0;
  }
  void clear() { counts_.clear(); }

 private:
  std::unordered_map<std::size_t, std::uint32_t> counts_;
};

/// A table whose rows are counted.
class CountedTable {
 public:
  CountedTable(SqliteDatabase& database, const std::string& name, const std::string& key,
               int columns, TableTotal& total);

  bool has(std::int64_t id);
  /// Whether it has that row, by what it says itself.
  bool holds(std::int64_t id, std::uint64_t checksum);
  /// With all columns, for a row that add() is told of; what has its key goes.
  SqliteStatement& replace(std::int64_t id);
  void add(std::uint64_t checksum) { total_.add(checksum); }
  /// False where there is none.
  bool remove(std::int64_t id);

 private:
  bool forget(std::int64_t id);

  SqliteStatement find_;
  SqliteStatement replace_;
  SqliteStatement remove_;
  TableTotal& total_;
};

/// Makes the edits of a change within a transaction that is open. Throws StoreError where one does
/// not fit what is in the store.
class StoreWriter {
 public:
  /// `head` and `labels` follow what is written.
  StoreWriter(SqliteDatabase& database, StoreHead& head, LabelHashes& labels);

  void operator()(const PlaceAdded& edit);
  void operator()(const PlaceMoved& edit);
  void operator()(const PlaceRenamed& edit);
  void operator()(const GridAdapted& edit);
  void operator()(const PlaceRemoved& edit);
  void operator()(const LinkAdded& edit);
  void operator()(const LinkRemoved& edit);
  void operator()(const LinkLearned& edit);
  void operator()(const MapCleared& edit);
  /// After the last edit.
  void finish();

 private:
  [[noreturn]] void refuse(const std::string& why) const;
  Place read(PlaceId id);
  void write(const Place& place);
  void writeGridOf(PlaceId id, const EvidenceGrid* grid);
  void claim(const std::string& label, PlaceId id);
  /// Its number, and what it says unless that is damaged.
  std::optional<std::int64_t> findLink(PlaceId first, PlaceId second, std::optional<LinkRow>& link);
  std::int64_t newLinkId(PlaceId first);
  void write(const LinkRow& row);
  void write(const std::optional<Traversal>& traversal);
  void removeLinksOfRemoved();

  SqliteDatabase& database_;
  StoreHead& head_;
  LabelHashes& labels_;
  CountedTable places_;
  CountedTable links_;
  CountedTable grids_;
  CountedTable readings_;
  CountedTable traversals_;
  PlaneWriter planes_;
  SqliteStatement read_place_;
  SqliteStatement find_link_;
  SqliteStatement last_link_;
  SqliteStatement last_traversal_;
  std::unordered_set<PlaceId> removed_;  ///< whose links are still there
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_WRITER_H
