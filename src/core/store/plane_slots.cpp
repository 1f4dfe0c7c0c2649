#include "core/store/plane_slots.h"

#include <array>
#include <vector>

#include "core/store/packed_bytes.h"
#include "core/store/row_checksum.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kRowBytes = static_cast<std::size_t>(kPlaneSlots) * kPlaneSlotBytes;
constexpr std::size_t kKeyBytes = 2 * sizeof(std::uint64_t);

std::size_t offsetOf(PlaceId place) {
  return static_cast<std::size_t>(place % kPlaneSlots) * kPlaneSlotBytes;
}

std::uint64_t checksumOf(PlaceId place, const CellPlanes& planes) {
  RowChecksum checksum;
  checksum.add(place);
  for (const BitPlane* plane : {&planes.occupied, &planes.empty}) {
    for (const std::uint64_t row : *plane) checksum.add(row);
  }
  return checksum.value();
}

std::vector<unsigned char> pack(PlaceId place, std::uint64_t checksum, const CellPlanes& planes) {
  BytePacker bytes;
  bytes.add(place).add(checksum);
  for (const BitPlane* plane : {&planes.occupied, &planes.empty}) {
    for (const std::uint64_t row : *plane) bytes.add(row);
  }
  return bytes.bytes();
}

}  // namespace

PlaneSlot::PlaneSlot(const void* bytes, std::size_t size, std::int64_t slot) {
  if (bytes == nullptr || size != kRowBytes) return;
  const auto* begin =
      static_cast<const unsigned char*>(bytes) + static_cast<std::size_t>(slot) * kPlaneSlotBytes;
  ByteUnpacker key(begin, kKeyBytes);
  id_ = key.take<PlaceId>();
  checksum_ = key.take<std::uint64_t>();
  planes_ = begin + kKeyBytes;
}

std::optional<CellPlanes> PlaneSlot::planesOf(PlaceId place) const {
  if (planes_ == nullptr || id_ != place) return std::nullopt;
  CellPlanes planes;
  ByteUnpacker bytes(planes_, kPlaneSlotBytes - kKeyBytes);
  for (BitPlane* plane : {&planes.occupied, &planes.empty}) {
    for (std::uint64_t& row : *plane) row = bytes.take<std::uint64_t>();
  }
  if (checksumOf(place, planes) != checksum_) return std::nullopt;
  return planes;
}

void PlaneWriter::put(PlaceId place, const CellPlanes& planes) {
  if (!open(place / kPlaneSlots)) create(place / kPlaneSlots);
  forget(offsetOf(place));
  const std::uint64_t checksum = checksumOf(place, planes);
  const std::vector<unsigned char> slot = pack(place, checksum, planes);
  blob_->write(slot.data(), slot.size(), offsetOf(place));
  total_.add(checksum);
}

void PlaneWriter::remove(PlaceId place) {
  if (!open(place / kPlaneSlots)) return;
  forget(offsetOf(place));
  const std::array<unsigned char, kPlaneSlotBytes> nothing{};
  blob_->write(nothing.data(), nothing.size(), offsetOf(place));
  if (!isRowEmpty()) return;
  blob_.reset();
  SqliteStatement(database_, "DELETE FROM planes WHERE id = ?").bind(place / kPlaneSlots).run();
}

bool PlaneWriter::open(std::int64_t row) {
  if (blob_ && row_ == row) return true;
  blob_.reset();
  SqliteStatement query(database_, "SELECT length(slots) FROM planes WHERE id = ?");
  if (!query.bind(row).step()) return false;
  if (query.integer(0) != static_cast<std::int64_t>(kRowBytes)) return false;
  query.reset();
  blob_.emplace(database_, "planes", "slots", row);
  row_ = row;
  return true;
}

// In the place of one that is damaged, too: its bit planes are made anew from their grids then.
void PlaneWriter::create(std::int64_t row) {
  SqliteStatement(database_, "REPLACE INTO planes VALUES(?, zeroblob(?))")
      .bind(row)
      .bind(static_cast<std::int64_t>(kRowBytes))
      .run();
  open(row);
}

// Takes what lies in a slot out of the total.
void PlaneWriter::forget(std::size_t offset) {
  std::array<unsigned char, kKeyBytes> key{};
  blob_->read(key.data(), key.size(), offset);
  ByteUnpacker bytes(key.data(), key.size());
  const auto id = bytes.take<PlaceId>();
  const auto checksum = bytes.take<std::uint64_t>();
  if (id != kNoPlace || checksum != 0) total_.remove(checksum);
}

bool PlaneWriter::isRowEmpty() {
  std::vector<unsigned char> bytes(kRowBytes);
  blob_->read(bytes.data(), bytes.size(), 0);
  for (const unsigned char byte : bytes) {
    if (byte != 0) return false;
  }
  return true;
}

}  // namespace place_memory::core
