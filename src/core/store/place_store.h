#ifndef PLACE_MEMORY_CORE_STORE_PLACE_STORE_H
#define PLACE_MEMORY_CORE_STORE_PLACE_STORE_H

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/grid/cell_planes.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/store_opening.h"

namespace place_memory::core {

class SqliteDatabase;

/// Places, grids and links in an SQLite file: every change is one transaction, ids are never used
/// again, and grids are read on demand.
///
/// The journal is SQLite's default, a rollback journal, and not a write-ahead log: the store is
/// then one file that can be copied and lies on any file system, and a change is rare and small
/// beside the scan it comes from. The file is locked while it is open, because a second writer
/// would change the map behind the back of the one who has it in memory. Not thread-safe.
class PlaceStore {
 public:
  /// Opens the file, or creates it where there is none (its folder has to be there); "" stands for
  /// a store in memory that ends with this object. All grids have cells of `cell_size` [m].
  ///
  /// Throws StoreError where the file is not a place store, was cut short or damaged, was written
  /// by a newer version, holds grids with cells of another size, or cannot be read, written or
  /// locked; the file is then as it was. A store that an older version wrote is brought to this
  /// one.
  PlaceStore(const std::string& path, double cell_size, const StoreOpening& opening = {});
  ~PlaceStore();
  PlaceStore(PlaceStore&&) noexcept;
  PlaceStore& operator=(PlaceStore&&) noexcept;

  /// Every place and link. Throws StoreError.
  PlaceMap map() const;
  /// Of the next place.
  PlaceId nextId() const;
  /// Of the next session.
  SessionId nextSession() const;
  /// Throws StoreError where the place is unknown or its grid cannot be read.
  EvidenceGrid grid(PlaceId id) const;
  /// Calls with every grid, by rising id of its place. Throws StoreError.
  void forEachGrid(const std::function<void(PlaceId, const EvidenceGrid&)>& call) const;
  /// The same with what matching needs of each grid, a quarter of its size. Throws StoreError.
  void forEachPlanes(const std::function<void(PlaceId, const CellPlanes&)>& call) const;

  // Each of these throws StoreError where the change cannot be made; the store is then as it was.

  /// One transaction, whatever its edits.
  void commit(const MapChange& change);

  /// Adds a place with a new id, whatever `place.id` is, and links it to `came_from` unless that is
  /// kNoPlace. Returns the id.
  PlaceId add(const Place& place, const EvidenceGrid& grid, PlaceId came_from);
  void rename(PlaceId id, const std::string& label);
  /// Puts another grid in the place of the one that the place has.
  void update(PlaceId id, const EvidenceGrid& grid);
  /// With its grid and its links.
  void remove(PlaceId id);
  void clear();
  /// Makes one change of all that `changes` changes through this object: thousands of places are
  /// added in a second. What it throws is thrown again, with the store as it was before.
  void atOnce(const std::function<void()>& changes);

 private:
  std::unique_ptr<SqliteDatabase> database_;
  double cell_size_;
  StoreProgress progress_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_PLACE_STORE_H
