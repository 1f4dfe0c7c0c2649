#ifndef PLACE_MEMORY_CORE_STORE_STORE_ROWS_H
#define PLACE_MEMORY_CORE_STORE_STORE_ROWS_H

#include <cstddef>

#include "core/grid/cell_planes.h"
#include "core/store/sqlite.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/place.h"

namespace place_memory::core {

/// How many rows of a large store are gone through between two words on how far it has come.
constexpr std::size_t kPlacesBetweenReports = std::size_t{1} << 16U;

// How grids, and the bit planes that are made of them, lie in the tables of a store. Each row has a
// checksum of its own, so that damage is found where it is read.

/// Makes rows of a place that has none yet.
void insertGrid(SqliteDatabase& database, PlaceId place, const EvidenceGrid& grid);
void insertPlanes(SqliteDatabase& database, PlaceId place, const CellPlanes& planes);

/// Changes the rows of a place. Returns whether it has any.
bool updateGrid(SqliteDatabase& database, PlaceId place, const EvidenceGrid& grid);

/// The columns `checksum` and `cells` of the table grid, from `column` on. Throws StoreError where
/// they are not as they were written.
EvidenceGrid readGrid(const SqliteDatabase& database, const SqliteStatement& row, int column,
                      double cell_size);
/// The columns `checksum` and `cells` of the table planes, likewise.
CellPlanes readPlanes(const SqliteDatabase& database, const SqliteStatement& row, int column);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_STORE_ROWS_H
