#include "core/store/store_migration.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include "core/store/old_store.h"
#include "core/store/store_copy.h"
#include "core/store/store_head.h"
#include "core/store/store_schema.h"
#include "core/store/store_writer.h"
#include "core/store/unfinished_file.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kEditsBetweenReports = std::size_t{1} << 16U;

// Two copies of an old store become stores of one identity.
void fold(const PlaceIdentity& identity, PlaceIdentity& into) {
  for (std::size_t i = 0; i < into.size(); ++i) into[i] ^= identity[i];
}

// What the tables hold stays as it is, damaged rows too: they are named when they are read.
void copyTables(const SqliteDatabase& old, std::uint32_t format, SqliteDatabase& database) {
  copyDatabase(old, database);
  SqliteTransaction transaction(database);
  const std::optional<StoreHead> head = readHead(database, storeTablesOf(format));
  bringSchemaToFormat5(database, format);
  if (head) writeHead(database, *head);
  transaction.commit();
}

void convert(SqliteDatabase& old, SqliteDatabase& database, double cell_size,
             const StoreProgress& progress) {
  createSchema(database);
  SqliteTransaction transaction(database);
  StoreHead head;
  head.cell_size = cell_size;
  LabelHashes labels;
  StoreWriter writer(database, head, labels);
  std::size_t edits = 0;
  readOldStore(old, cell_size, [&](const MapChange& change) {
    for (const MapEdit& edit : change.edits) {
      if (const auto* added = std::get_if<PlaceAdded>(&edit)) {
        fold(added->place.identity, head.identity);
      }
      std::visit(writer, edit);
      if (progress && ++edits % kEditsBetweenReports == 0) {
        progress("brought " + std::to_string(edits) +
                 " places and links to the new format of the store");
      }
    }
    head.version = change.version;
    head.stamp = change.stamp;
  });
  writer.finish();
  head.next_place = std::max(head.next_place, oldNextId(old));
  if (head.identity == PlaceIdentity{}) head.identity = makeIdentity();
  writeHead(database, head);
  transaction.commit();
}

void bringOver(const StoreFile& old, SqliteDatabase& database, double cell_size,
               const StoreProgress& progress) {
  if (old.format >= kFirstFormatWithoutIndexes) {
    copyTables(*old.database, old.format, database);
  } else {
    convert(*old.database, database, cell_size, progress);
  }
}

// Returns why it could not be made, or "".
std::string replaceFile(const StoreFile& old, const std::string& path, double cell_size,
                        const StoreProgress& progress) {
  try {
    UnfinishedFile file(path);
    {
      SqliteDatabase database(file.name(), true);
      bringOver(old, database, cell_size, progress);
    }
    const std::string kept = keepFileAs(path, "format-" + std::to_string(old.format));
    file.publishOver();
    if (progress) {
      progress("brought the store " + path + " from format " + std::to_string(old.format) + " to " +
               std::to_string(kStoreFormat) + "; the old file is kept as " + kept);
    }
  } catch (const SqliteError& error) {
    if (!error.isOfDisk()) throw;
    return error.what();
  } catch (const std::filesystem::filesystem_error& error) {
    return "place store " + path + ": " + error.code().message();
  }
  return "";
}

}  // namespace

StoreFile migrateStore(StoreFile old, const std::string& path, double cell_size,
                       const StoreOpening& opening, std::unique_ptr<SqliteDatabase>& held) {
  if (old.format < kFirstFormatWithoutIndexes) {
    checkOldStore(*old.database, cell_size);
  } else if (const auto head = readHead(*old.database, storeTablesOf(old.format))) {
    requireCellSize(path, head->cell_size, cell_size);
  }
  StoreFile result;
  result.format = kStoreFormat;
  result.why_read_only = old.why_read_only;
  if (result.why_read_only.empty()) {
    result.why_read_only = replaceFile(old, path, cell_size, opening.progress);
    if (result.why_read_only.empty()) {
      old.database.reset();
      return openStoreFile(path, cell_size, opening);
    }
  }
  result.database = std::make_unique<SqliteDatabase>(":memory:", true);
  bringOver(old, *result.database, cell_size, opening.progress);
  held = std::move(old.database);
  return result;
}

}  // namespace place_memory::core
