#ifndef PLACE_MEMORY_CORE_INDEX_PLACE_INDEX_H
#define PLACE_MEMORY_CORE_INDEX_PLACE_INDEX_H

#include <cstddef>
#include <memory>
#include <vector>

#include "core/grid/cell_planes.h"
#include "core/index/place_block.h"

namespace place_memory::core {

/// The ids of all places and the classes of their cells, which matching needs of every one, and
/// nothing else: some 1.1 KiB a place where ids rise.
///
/// A copy is a snapshot: it shares its blocks with the original and costs a pointer a block, so a
/// match may run on a copy while places are learned, changed and removed in the original. A change
/// copies one or two blocks, however many places there are, and none that no snapshot shares.
class PlaceIndex {
 public:
  static constexpr std::size_t kBlockSize = PlaceBlock::kCapacity;  ///< places

  using Block = PlaceBlock;

  std::size_t size() const { return size_; }

  /// All places, by rising id from block to block; each block has at least one.
  const std::vector<std::shared_ptr<const Block>>& blocks() const { return blocks_; }

  /// The classes of a place's cells. Throws std::out_of_range where the id is not in the index.
  CellPlanes cells(PlaceId id) const;

  /// Adds the place, or replaces it where its id is in the index. Cheapest where ids rise.
  void put(PlaceId id, const EvidenceGrid& grid);
  void put(PlaceId id, const CellPlanes& cells);

  /// Whether the place was in the index.
  bool erase(PlaceId id);

  void clear();

 private:
  /// The block in which the id is or belongs; blocks_.size() where it belongs behind all of them.
  std::size_t blockOf(PlaceId id) const;
  /// The block, copied first where a snapshot shares it.
  Block& changeable(std::size_t at);
  /// Moves the upper half of a full block to a block of its own behind it.
  void split(std::size_t at);
  /// Moves the places of the block behind this one into it, where there is one and they fit.
  void joinNext(std::size_t at);

  std::vector<std::shared_ptr<const Block>> blocks_;
  std::size_t size_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_INDEX_PLACE_INDEX_H
