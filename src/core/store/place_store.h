#ifndef PLACE_MEMORY_CORE_STORE_PLACE_STORE_H
#define PLACE_MEMORY_CORE_STORE_PLACE_STORE_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/grid/cell_planes.h"
#include "core/map/kept_map.h"
#include "core/store/store_history.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/sonar_reading.h"
#include "place_memory/core/store_opening.h"

namespace place_memory::core {

/// The map, its grids and the readings they were laid from in an SQLite file (format 5): a change
/// of the map is one transaction, ids are never used again, and grids are read on demand.
///
/// The journal is SQLite's default, a rollback journal, and not a write-ahead log: the store is
/// then one file that lies on any file system, and a change is rare and small beside the scan it
/// comes from. The file is locked while it is open, because a second writer would change the map
/// behind the back of the one who has it in memory.
///
/// Threads: one call at a time. Whoever shares a store guards it by a mutex of its own and not by
/// that of map or index: commit() waits for the disk and so does, meanwhile, who asks for a grid.
class PlaceStore {
 public:
  /// Opens the file, or creates it where there is none (its folder has to be there); "" stands for
  /// a store in memory that ends with this object. All grids have cells of `cell_size` [m].
  ///
  /// Throws StoreError where the file is not a place store, was cut short, has a damaged structure,
  /// was written by a newer version, holds grids with cells of another size, or cannot be read or
  /// locked; the file is then as it was. Single damaged rows are left out: setAside(). What cannot
  /// be written now is read: whyReadOnly(). A store that an older version wrote is brought to this
  /// one; the old file stays beside it under a name that opening.progress is told.
  PlaceStore(const std::string& path, double cell_size, const StoreOpening& opening = {});
  ~PlaceStore();
  PlaceStore(PlaceStore&&) noexcept;
  PlaceStore& operator=(PlaceStore&&) noexcept;

  /// Absolute; "": in memory.
  const std::string& path() const;
  /// Why a change cannot be kept now, or "". Each commit() tries anew and so changes this.
  const std::string& whyReadOnly() const;
  /// What is damaged and was left out, a sentence for each place, link, grid, bit planes or scan.
  /// Known when the store is opened; of a store too large to be checked in full, when it is read.
  const std::vector<std::string>& setAside() const;
  /// Of this store and no other one.
  const PlaceIdentity& identity() const;

  /// Every place and link, and version and stamp of the newest change. Throws StoreError.
  PlaceMap map() const;
  /// Higher than any that was given before, be it to a place that is gone.
  PlaceId nextId() const;
  /// Higher than that of any place there ever was; kFirstSession in a new store.
  SessionId nextSession() const;

  /// Throws StoreError where the place is unknown or its grid cannot be read.
  EvidenceGrid grid(PlaceId id) const;
  /// Of the scan from which the place was learned, in the place's frame, to some micrometres; empty
  /// where they are not known, as in stores that an older version wrote. Throws like grid().
  std::vector<SonarReading> readings(PlaceId id) const;
  /// Calls with every grid that can be read, by rising id of its place. Throws StoreError.
  void forEachGrid(const std::function<void(PlaceId, const EvidenceGrid&)>& call) const;
  /// The same with what matching needs of each grid, a quarter of its size.
  void forEachPlanes(const std::function<void(PlaceId, const CellPlanes&)>& call) const;

  /// Makes all edits, in one transaction. They have to fit the map (PlaceMap::check()); the ids of
  /// places that are added are nextId() or higher, each higher than the one before, and each has a
  /// grid. Thousands are added in a second by one change. Throws StoreError where it cannot be
  /// made; the store is then as it was.
  void commit(const MapChange& change);
  /// The same, and `scans` take the place of those before.
  void commit(const MapChange& change, const KeptMap& scans);
  /// The same, and the history follows.
  void commit(const MapChange& change, const HistoryEdit& history);

  /// The newest changes that commit() was told to put into the history, newest first, no more than
  /// `most`. Throws StoreError.
  std::vector<PastChange> history(std::size_t most) const;
  /// What undoes the change of that version; nothing where it cannot be undone. Throws StoreError.
  std::optional<std::vector<MapEdit>> inverse(std::uint64_t version) const;

  /// Writes a file with all that is in the store; see saveCopy().
  void saveAs(const std::string& path) const;

  /// The scans that were taken while the robot drove, and what ties them. Those that are damaged
  /// are left out, with their ties; those that were a place that is gone are no place.
  KeptMap scans() const;

  /// How links were travelled, the oldest first, also those of places that are gone: the newest
  /// million. Those that are damaged are left out. Throws StoreError.
  std::vector<Traversal> traversals() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_PLACE_STORE_H
