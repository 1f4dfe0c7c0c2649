#ifndef PLACE_MEMORY_CORE_STORE_STORE_HISTORY_H
#define PLACE_MEMORY_CORE_STORE_STORE_HISTORY_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/store/sqlite.h"
#include "core/store/store_head.h"
#include "core/store/store_reader.h"
#include "place_memory/core/map_change.h"

namespace place_memory::core {

/// Of grids and readings that the inverse of one change may hold [bytes].
constexpr std::size_t kMostInverseBytes = std::size_t{64} << 20U;

/// What becomes of the history by a change that is made.
struct HistoryEdit {
  struct Row {
    PastChange change;
    std::vector<MapEdit> inverse;  ///< that undoes it
  };

  std::optional<Row> add;
  std::vector<std::uint64_t> remove;  ///< versions of changes that are undone
};

/// Within a transaction. The oldest rows go where there are more than 200 of them, or more than
/// 128 MiB. `head` follows what is written.
void writeHistory(SqliteDatabase& database, const HistoryEdit& edit, StoreHead& head);

/// The newest changes, newest first, no more than `most`; what is damaged is left out.
std::vector<PastChange> readHistory(SqliteDatabase& database, std::size_t most);

/// What undoes the change of that version; nothing where it is not in the history, cannot be
/// undone, or is damaged. `cell_size` is that of the grids [m].
std::optional<std::vector<MapEdit>> readInverse(SqliteDatabase& database, std::uint64_t version,
                                                double cell_size);

/// Names what of the history is not as it was written; `found`: of its table. `head` is nothing
/// where it is damaged.
void checkHistory(SqliteDatabase& database, const StoreHead* head, Damages& damages,
                  StoreTotals& found);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_HISTORY_H
