#ifndef PLACE_MEMORY_CORE_STORE_PLANE_SLOTS_H
#define PLACE_MEMORY_CORE_STORE_PLANE_SLOTS_H

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/grid/cell_planes.h"
#include "core/store/sqlite.h"
#include "core/store/store_head.h"

namespace place_memory::core {

/// The bit planes of this many places lie in one row, each in a slot of its own: a start reads them
/// in stretches, and a place that is learned or changed writes its slot alone.
constexpr std::int64_t kPlaneSlots = 16;
constexpr std::size_t kPlaneSlotBytes = 2 * sizeof(std::uint64_t) * (1 + kGridSize);

/// A slot of the `bytes` of a row, of which there may be too few.
class PlaneSlot {
 public:
  PlaneSlot(const void* bytes, std::size_t size, std::int64_t slot);

  /// Of this place and as they were written; otherwise nothing.
  std::optional<CellPlanes> planesOf(PlaceId place) const;
  bool isEmpty() const { return id_ == kNoPlace && checksum_ == 0; }
  std::uint64_t checksum() const { return checksum_; }

 private:
  const unsigned char* planes_ = nullptr;
  PlaceId id_ = kNoPlace;
  std::uint64_t checksum_ = 0;
};

/// Writes slots, and keeps count of them.
class PlaneWriter {
 public:
  PlaneWriter(SqliteDatabase& database, TableTotal& total) : database_(database), total_(total) {}

  void put(PlaceId place, const CellPlanes& planes);
  void remove(PlaceId place);
  /// Before a transaction ends, and after rows were deleted otherwise.
  void close() { blob_.reset(); }

 private:
  /// False where there is no such row.
  bool open(std::int64_t row);
  void create(std::int64_t row);
  void forget(std::size_t offset);
  bool isRowEmpty();

  SqliteDatabase& database_;
  TableTotal& total_;
  std::optional<SqliteBlob> blob_;
  std::int64_t row_ = -1;  ///< of blob_
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_PLANE_SLOTS_H
