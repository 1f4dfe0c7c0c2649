#ifndef PLACE_MEMORY_CORE_INDEX_PLACE_BLOCK_H
#define PLACE_MEMORY_CORE_INDEX_PLACE_BLOCK_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/grid/cell_totals.h"
#include "core/kernels/plane_block.h"
#include "place_memory/core/place_id.h"

namespace place_memory::core {

/// Up to eight places by rising id, their cells as the matching kernels read them.
class PlaceBlock {
 public:
  static constexpr std::size_t kCapacity = kBlockPlaces;

  std::size_t size() const { return size_; }
  /// Slots in [0, size()).
  PlaceId operator[](std::size_t slot) const { return ids_[slot]; }
  const PlaceId* begin() const { return ids_.data(); }
  const PlaceId* end() const { return ids_.data() + size_; }
  const CellTotals& totals(std::size_t slot) const { return totals_[slot]; }

  /// Slots from size() on are unsensed.
  const PlaneBlock& planes() const { return planes_; }
  /// The same planes in 16 x 16 cells, for screening.
  const CoarsestBlock& coarsest() const { return coarsest_; }

  /// First slot whose id is not below `id`; size() where there is none.
  std::size_t slotOf(PlaceId id) const;
  bool holds(PlaceId id) const;

  /// At a slot in [0, size()), in the order of ids.
  void replace(std::size_t slot, PlaceId id, const CellPlanes& cells);
  /// Before the place at a slot in [0, size()], in the order of ids; size() < kCapacity.
  void insert(std::size_t slot, PlaceId id, const CellPlanes& cells);
  void erase(std::size_t slot);

 private:
  PlaneBlock planes_;
  CoarsestBlock coarsest_{};
  std::array<PlaceId, kCapacity> ids_{};
  std::array<CellTotals, kCapacity> totals_{};
  std::size_t size_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_INDEX_PLACE_BLOCK_H
