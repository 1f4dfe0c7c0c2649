#include "core/store/store_history.h"

#include <string>

#include "core/store/packed_edits.h"
#include "core/store/row_checksum.h"
#include "core/store/store_writer.h"
#include "core/store/table_scan.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kMostRows = 200;
constexpr std::int64_t kMostBytes = std::int64_t{128} << 20U;

constexpr char kColumns[] = "version, stamp_ns, change, checksum";

std::uint64_t checksumOf(std::int64_t version, std::int64_t stamp, const void* bytes,
                         std::size_t size) {
  return RowChecksum().add(version).add(stamp).add(bytes, size).value();
}

bool isAsWritten(const SqliteStatement& row) {
  return static_cast<std::uint64_t>(row.integer(3)) ==
         checksumOf(row.integer(0), row.integer(1), row.blob(2), row.size(2));
}

void add(CountedTable& table, const HistoryEdit::Row& row) {
  BytePacker bytes;
  bytes.add(row.change.words).add(static_cast<std::uint8_t>(row.change.can_be_undone));
  packEdits(row.inverse, bytes);
  const auto version = static_cast<std::int64_t>(row.change.version);
  const std::int64_t stamp = row.change.stamp.count();
  const std::uint64_t checksum =
      checksumOf(version, stamp, bytes.bytes().data(), bytes.bytes().size());
  table.replace(version)
      .bind(version)
      .bind(stamp)
      .bind(bytes.bytes().data(), bytes.bytes().size())
      .bind(static_cast<std::int64_t>(checksum))
      .run();
  table.add(checksum);
}

void removeOldest(SqliteDatabase& database, CountedTable& table) {
  std::vector<std::int64_t> too_old;
  std::size_t rows = 0;
  std::int64_t bytes = 0;
  SqliteStatement row(database,
                      "SELECT version, length(change) FROM history ORDER BY version DESC");
  while (row.step()) {
    bytes += row.integer(1);
    if (++rows > kMostRows || (rows > 1 && bytes > kMostBytes)) too_old.push_back(row.integer(0));
  }
  for (const std::int64_t version : too_old) table.remove(version);
}

}  // namespace

void writeHistory(SqliteDatabase& database, const HistoryEdit& edit, StoreHead& head) {
  CountedTable table(database, "history", "version", 4, head.totals.of(StoreTable::kHistory));
  for (const std::uint64_t version : edit.remove) table.remove(static_cast<std::int64_t>(version));
  if (!edit.add) return;
  add(table, *edit.add);
  removeOldest(database, table);
}

std::vector<PastChange> readHistory(SqliteDatabase& database, std::size_t most) {
  std::vector<PastChange> changes;
  SqliteStatement row(database,
                      std::string("SELECT ") + kColumns + " FROM history ORDER BY version DESC");
  while (changes.size() < most && row.step()) {
    if (!isAsWritten(row)) continue;
    PastChange change;
    change.version = static_cast<std::uint64_t>(row.integer(0));
    change.stamp = std::chrono::nanoseconds(row.integer(1));
    ByteUnpacker bytes(row.blob(2), row.size(2));
    change.words = bytes.takeText();
    change.can_be_undone = bytes.take<std::uint8_t>() != 0;
    if (bytes.good()) changes.push_back(change);
  }
  return changes;
}

std::optional<std::vector<MapEdit>> readInverse(SqliteDatabase& database, std::uint64_t version,
                                                double cell_size) {
  SqliteStatement row(database,
                      std::string("SELECT ") + kColumns + " FROM history WHERE version = ?");
  if (!row.bind(static_cast<std::int64_t>(version)).step() || !isAsWritten(row)) {
    return std::nullopt;
  }
  ByteUnpacker bytes(row.blob(2), row.size(2));
  bytes.takeText();
  if (bytes.take<std::uint8_t>() == 0) return std::nullopt;
  return unpackEdits(bytes, cell_size);
}

void checkHistory(SqliteDatabase& database, const StoreHead* head, Damages& damages,
                  StoreTotals& found) {
  TableFindings findings;
  const auto refuse = [&](std::int64_t version) {
    ++findings.bad;
    damages.add("the history of change " + std::to_string(version) +
                " is damaged: it cannot be undone");
  };
  scanTable(
      database, {"history", "version", kColumns},
      [&](const SqliteStatement& row) {
        findings.all.add(static_cast<std::uint64_t>(row.integer(3)));
        if (!isAsWritten(row)) refuse(row.integer(0));
      },
      [&](std::int64_t version) {
        findings.all.add(0);
        refuse(version);
      });
  found.of(StoreTable::kHistory) = findings.all;
  if (head != nullptr) {
    damages.add(
        compareTotals(head->totals.of(StoreTable::kHistory), findings, "rows of the history"));
  }
}

}  // namespace place_memory::core
