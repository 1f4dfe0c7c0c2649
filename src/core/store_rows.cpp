#include "store_rows.h"

#include <array>
#include <boost/crc.hpp>
#include <cstring>

namespace place_memory::core {
namespace {

constexpr std::size_t kWordBytes = sizeof(std::uint64_t);
constexpr std::size_t kPlaneBytes = kGridSize * kWordBytes;

/// Both planes, each row by row, the least significant byte of a row first on every machine.
using PlaneBytes = std::array<unsigned char, 2 * kPlaneBytes>;

std::int64_t checksum(const void* bytes, std::size_t size) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes, size);
  return crc.checksum();
}

void pack(const BitPlane& plane, unsigned char* bytes) {
  for (const std::uint64_t row : plane) {
    for (std::size_t i = 0; i < kWordBytes; ++i) {
      *bytes++ = static_cast<unsigned char>(row >> 8 * i & 0xffU);
    }
  }
}

void unpack(const unsigned char* bytes, BitPlane& plane) {
  for (std::uint64_t& row : plane) {
    row = 0;
    for (std::size_t i = 0; i < kWordBytes; ++i) row |= std::uint64_t{*bytes++} << 8 * i;
  }
}

PlaneBytes packed(const CellPlanes& planes) {
  PlaneBytes bytes;
  pack(planes.occupied, bytes.data());
  pack(planes.empty, bytes.data() + kPlaneBytes);
  return bytes;
}

/// The blob behind a checksum, which has this size.
const void* checkedBlob(const SqliteDatabase& database, const SqliteStatement& row, int column,
                        std::size_t size, const char* what) {
  const void* bytes = row.blob(column + 1);
  if (row.size(column + 1) != size || checksum(bytes, size) != row.integer(column)) {
    throwStoreError(database.path(), std::string("is damaged: ") + what + " not as written");
  }
  return bytes;
}

}  // namespace

void insertGrid(SqliteDatabase& database, PlaceId place, const EvidenceGrid& grid) {
  SqliteStatement(database, "INSERT INTO grid VALUES(?, ?, ?, ?)")
      .bind(place)
      .bind(grid.geometry().cell_size)
      .bind(checksum(grid.cells().data(), grid.cells().size()))
      .bind(grid.cells().data(), grid.cells().size())
      .run();
}

void insertPlanes(SqliteDatabase& database, PlaceId place, const CellPlanes& planes) {
  const PlaneBytes bytes = packed(planes);
  SqliteStatement(database, "INSERT INTO planes VALUES(?, ?, ?)")
      .bind(place)
      .bind(checksum(bytes.data(), bytes.size()))
      .bind(bytes.data(), bytes.size())
      .run();
}

bool updateGrid(SqliteDatabase& database, PlaceId place, const EvidenceGrid& grid) {
  SqliteStatement(database, "UPDATE grid SET checksum = ?, cells = ? WHERE place_id = ?")
      .bind(checksum(grid.cells().data(), grid.cells().size()))
      .bind(grid.cells().data(), grid.cells().size())
      .bind(place)
      .run();
  if (sqlite3_changes(database.handle()) == 0) return false;
  const PlaneBytes bytes = packed(CellPlanes(grid));
  SqliteStatement(database, "UPDATE planes SET checksum = ?, cells = ? WHERE place_id = ?")
      .bind(checksum(bytes.data(), bytes.size()))
      .bind(bytes.data(), bytes.size())
      .bind(place)
      .run();
  return true;
}

EvidenceGrid readGrid(const SqliteDatabase& database, const SqliteStatement& row, int column,
                      double cell_size) {
  EvidenceGrid grid(GridGeometry{cell_size});
  std::memcpy(grid.cells().data(), checkedBlob(database, row, column, kGridCells, "a grid is"),
              kGridCells);
  return grid;
}

CellPlanes readPlanes(const SqliteDatabase& database, const SqliteStatement& row, int column) {
  const auto* bytes = static_cast<const unsigned char*>(
      checkedBlob(database, row, column, sizeof(PlaneBytes), "the bit planes of a place are"));
  CellPlanes planes;
  unpack(bytes, planes.occupied);
  unpack(bytes + kPlaneBytes, planes.empty);
  return planes;
}

}  // namespace place_memory::core
