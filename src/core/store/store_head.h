#ifndef PLACE_MEMORY_CORE_STORE_STORE_HEAD_H
#define PLACE_MEMORY_CORE_STORE_STORE_HEAD_H

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/store/sqlite.h"
#include "place_memory/core/place.h"

namespace place_memory::core {

/// The tables whose rows are counted, in the order of the totals. Others may follow them.
enum class StoreTable : std::size_t {
  kPlace,
  kLink,
  kGrid,
  kPlanes,
  kReadings,
  kNode,
  kHistory,
  kTie,
  kWheels,
  kTraversal
};
constexpr std::size_t kStoreTables = 10;
/// How many are counted by the head of a store of format 3 or later.
constexpr std::size_t storeTablesOf(std::uint32_t format) {
  return format == 3 ? 7 : format == 4 ? 9 : kStoreTables;
}

/// How many rows a table has, and the sum of their checksums mod 2^64: by these it is noticed that
/// a row is gone, or is an older one.
struct TableTotal {
  std::uint64_t rows = 0;
  std::uint64_t sum = 0;

  void add(std::uint64_t checksum) {
    ++rows;
    sum += checksum;
  }
  void remove(std::uint64_t checksum) {
    --rows;
    sum -= checksum;
  }
  bool operator==(const TableTotal& other) const { return rows == other.rows && sum == other.sum; }
};

class StoreTotals {
 public:
  TableTotal& of(StoreTable table) { return totals_[static_cast<std::size_t>(table)]; }
  const TableTotal& of(StoreTable table) const { return totals_[static_cast<std::size_t>(table)]; }
  bool operator==(const StoreTotals& other) const { return totals_ == other.totals_; }

 private:
  std::array<TableTotal, kStoreTables> totals_{};
};

/// What the one row of the table store says.
struct StoreHead {
  PlaceIdentity identity{};
  double cell_size = 0.0;
  PlaceId next_place = 1;
  SessionId next_session = kFirstSession;
  std::uint64_t version = 0;
  std::chrono::nanoseconds stamp{0};
  StoreTotals totals;

  /// Of the same map.
  bool matches(const StoreHead& other) const {
    return next_place == other.next_place && next_session == other.next_session &&
           version == other.version && stamp == other.stamp && totals == other.totals;
  }
};

/// Throws StoreError, saying what to do, where a store's grids have cells of another size [m] than
/// are wanted.
void requireCellSize(const std::string& path, double of_store, double wanted);

/// 128 bits of chance.
PlaceIdentity makeIdentity();

/// Nothing where the row is not there or not as written. `tables`: how many are counted in it.
std::optional<StoreHead> readHead(SqliteDatabase& database, std::size_t tables = kStoreTables);
void writeHead(SqliteDatabase& database, const StoreHead& head);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_HEAD_H
