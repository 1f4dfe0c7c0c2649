#include "core/store/store_migration.h"

#include "core/store/store_rows.h"

namespace place_memory::core {
namespace {

void convert(SqliteDatabase& database, const StoreProgress& progress) {
  std::size_t converted = 0;
  SqliteStatement grid(database, "SELECT place_id, checksum, cells FROM grid ORDER BY place_id");
  while (grid.step()) {
    insertPlanes(database, grid.integer(0), CellPlanes(readGrid(database, grid, 1, 1.0)));
    if (progress && ++converted % kPlacesBetweenReports == 0) {
      progress("brought " + std::to_string(converted) + " places to the new format of the store");
    }
  }
}

}  // namespace

void addPlanesToStore(SqliteDatabase& database, const StoreProgress& progress) {
  SqliteTransaction transaction(database);
  database.execute(kPlanesSchema);
  convert(database, progress);
  database.execute("PRAGMA user_version = 2");
  transaction.commit();
}

}  // namespace place_memory::core
