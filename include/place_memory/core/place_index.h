#ifndef PLACE_MEMORY_CORE_PLACE_INDEX_H
#define PLACE_MEMORY_CORE_PLACE_INDEX_H

#include <cstddef>
#include <memory>
#include <vector>

#include "place_memory/core/cell_planes.h"
#include "place_memory/core/place.h"

namespace place_memory::core {

/// What matching needs of every place, and nothing else.
///
/// A copy is a snapshot: it shares its blocks with the original and costs a pointer a block, so a
/// match may run on a copy while places are learned, moved and removed in the original.
class PlaceIndex {
 public:
  static constexpr std::size_t kBlockSize = 64;  ///< places

  struct Entry {
    PlaceId id = kNoPlace;
    Pose2d map_from_place;
    CellPlanes planes;
  };
  using Block = std::vector<Entry>;  ///< 1 to kBlockSize entries, by rising id

  std::size_t size() const { return size_; }

  /// All entries, by rising id from block to block.
  const std::vector<std::shared_ptr<const Block>>& blocks() const { return blocks_; }

  /// Adds the place, or replaces it where its id is in the index. Cheapest where ids rise.
  void put(PlaceId id, const Pose2d& map_from_place, const EvidenceGrid& grid);

  /// Whether the place was in the index.
  bool erase(PlaceId id);

  void clear();

 private:
  /// The block in which the id is or belongs; blocks_.size() where it belongs behind all of them.
  std::size_t blockOf(PlaceId id) const;

  std::vector<std::shared_ptr<const Block>> blocks_;
  std::size_t size_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_PLACE_INDEX_H
