#include "core/store/store_head.h"

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "core/store/packed_bytes.h"
#include "core/store/row_checksum.h"

namespace place_memory::core {
namespace {

std::vector<unsigned char> pack(const StoreTotals& totals, std::size_t tables) {
  BytePacker bytes;
  for (std::size_t i = 0; i < tables; ++i) {
    const TableTotal& total = totals.of(static_cast<StoreTable>(i));
    bytes.add(total.rows).add(total.sum);
  }
  return bytes.bytes();
}

bool unpack(const void* bytes, std::size_t size, std::size_t tables, StoreTotals& totals) {
  ByteUnpacker unpacker(bytes, size);
  for (std::size_t i = 0; i < tables; ++i) {
    TableTotal& total = totals.of(static_cast<StoreTable>(i));
    total.rows = unpacker.take<std::uint64_t>();
    total.sum = unpacker.take<std::uint64_t>();
  }
  return unpacker.good() && unpacker.left() == 0;
}

std::int64_t checksumOf(const StoreHead& head, std::size_t tables) {
  const std::vector<unsigned char> totals = pack(head.totals, tables);
  return static_cast<std::int64_t>(RowChecksum()
                                       .add(std::int64_t{1})
                                       .add(head.identity.data(), head.identity.size())
                                       .add(head.cell_size)
                                       .add(head.next_place)
                                       .add(head.next_session)
                                       .add(head.version)
                                       .add(std::int64_t{head.stamp.count()})
                                       .add(totals.data(), totals.size())
                                       .value());
}

// Cell sizes that went through text, as in a YAML file, may differ in the last digits.
constexpr double kCellSizeTolerance = 1e-9;

}  // namespace

void requireCellSize(const std::string& path, double of_store, double wanted) {
  if (std::abs(of_store - wanted) <= kCellSizeTolerance) return;
  throwStoreError(path, "its grids have cells of " + std::to_string(of_store) + " m, but " +
                            std::to_string(wanted) +
                            " m are configured. Set that cell size, or name another file");
}

PlaceIdentity makeIdentity() {
  std::random_device random;
  PlaceIdentity identity{};
  for (std::uint8_t& byte : identity) byte = static_cast<std::uint8_t>(random());
  return identity;
}

std::optional<StoreHead> readHead(SqliteDatabase& database, std::size_t tables) {
  SqliteStatement row(database,
                      "SELECT identity, cell_size, next_place, next_session, map_version, "
                      "map_stamp_ns, totals, checksum FROM store WHERE id = 1");
  try {
    if (!row.step()) return std::nullopt;
  } catch (const SqliteError& error) {
    if (error.code() != SQLITE_CORRUPT) throw;
    return std::nullopt;
  }
  StoreHead head;
  if (row.size(0) != head.identity.size()) return std::nullopt;
  std::memcpy(head.identity.data(), row.blob(0), head.identity.size());
  head.cell_size = row.real(1);
  head.next_place = row.integer(2);
  head.next_session = row.integer(3);
  head.version = static_cast<std::uint64_t>(row.integer(4));
  head.stamp = std::chrono::nanoseconds(row.integer(5));
  if (!unpack(row.blob(6), row.size(6), tables, head.totals)) return std::nullopt;
  if (checksumOf(head, tables) != row.integer(7)) return std::nullopt;
  return head;
}

void writeHead(SqliteDatabase& database, const StoreHead& head) {
  const std::vector<unsigned char> totals = pack(head.totals, kStoreTables);
  SqliteStatement(database, "REPLACE INTO store VALUES(1, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(head.identity.data(), head.identity.size())
      .bind(head.cell_size)
      .bind(head.next_place)
      .bind(head.next_session)
      .bind(static_cast<std::int64_t>(head.version))
      .bind(std::int64_t{head.stamp.count()})
      .bind(totals.data(), totals.size())
      .bind(checksumOf(head, kStoreTables))
      .run();
}

}  // namespace place_memory::core
