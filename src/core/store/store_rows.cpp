#include "core/store/store_rows.h"

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

/// FNV-1a, over words: changes with any one word, and takes a tenth of a CRC-32's time, which is
/// what the start with a million places would otherwise consist of.
std::int64_t checksum(const CellPlanes& planes) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const BitPlane* plane : {&planes.occupied, &planes.empty}) {
    for (const std::uint64_t row : *plane) sum = (sum ^ row) * 0x100000001b3U;
  }
  return static_cast<std::int64_t>(sum);
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

[[noreturn]] void refuse(const SqliteDatabase& database, const char* what) {
  throwStoreError(database.path(), std::string("is damaged: ") + what + " not as written");
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
      .bind(checksum(planes))
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
  const CellPlanes planes(grid);
  const PlaneBytes bytes = packed(planes);
  SqliteStatement(database, "UPDATE planes SET checksum = ?, cells = ? WHERE place_id = ?")
      .bind(checksum(planes))
      .bind(bytes.data(), bytes.size())
      .bind(place)
      .run();
  return true;
}

EvidenceGrid readGrid(const SqliteDatabase& database, const SqliteStatement& row, int column,
                      double cell_size) {
  const void* cells = row.blob(column + 1);
  if (row.size(column + 1) != kGridCells || checksum(cells, kGridCells) != row.integer(column)) {
    refuse(database, "a grid is");
  }
  EvidenceGrid grid(GridGeometry{cell_size});
  std::memcpy(grid.cells().data(), cells, kGridCells);
  return grid;
}

CellPlanes readPlanes(const SqliteDatabase& database, const SqliteStatement& row, int column) {
  const auto* bytes = static_cast<const unsigned char*>(row.blob(column + 1));
  CellPlanes planes;
  if (row.size(column + 1) != sizeof(PlaneBytes)) refuse(database, "the bit planes of a place are");
  unpack(bytes, planes.occupied);
  unpack(bytes + kPlaneBytes, planes.empty);
  if (checksum(planes) != row.integer(column)) refuse(database, "the bit planes of a place are");
  return planes;
}

}  // namespace place_memory::core
