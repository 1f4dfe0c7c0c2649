#include "core/index/place_index.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace place_memory::core {

std::size_t PlaceIndex::blockOf(PlaceId id) const {
  const auto block = std::lower_bound(
      blocks_.begin(), blocks_.end(), id,
      [](const std::shared_ptr<const Block>& b, PlaceId key) { return (*b)[b->size() - 1] < key; });
  return static_cast<std::size_t>(block - blocks_.begin());
}

CellPlanes PlaceIndex::cells(PlaceId id) const {
  const std::size_t at = blockOf(id);
  if (at == blocks_.size() || !blocks_[at]->holds(id)) {
    throw std::out_of_range("place " + std::to_string(id) + " is not in the index");
  }
  return blocks_[at]->planes().get(blocks_[at]->slotOf(id));
}

void PlaceIndex::put(PlaceId id, const EvidenceGrid& grid) { put(id, CellPlanes(grid)); }

void PlaceIndex::put(PlaceId id, const CellPlanes& cells) {
  std::size_t at = blockOf(id);
  if (at == blocks_.size() && at > 0 && blocks_.back()->size() < kBlockSize) --at;
  if (at == blocks_.size()) {
    const auto block = std::make_shared<Block>();
    block->insert(0, id, cells);
    blocks_.push_back(block);
    ++size_;
    return;
  }
  if (blocks_[at]->holds(id)) {
    Block& block = changeable(at);
    block.replace(block.slotOf(id), id, cells);
    return;
  }
  if (blocks_[at]->size() == kBlockSize) {
    split(at);
    at = blockOf(id);
  }
  Block& block = changeable(at);
  block.insert(block.slotOf(id), id, cells);
  ++size_;
}

PlaceIndex::Block& PlaceIndex::changeable(std::size_t at) {
  std::shared_ptr<const Block>& block = blocks_[at];
  if (block.use_count() > 1) block = std::make_shared<Block>(*block);
  // Whoever gave up the last snapshot has read it before this: to give up a reference is to see
  // what happened before others gave up theirs. A fence would say the same, but not to the
  // sanitizer.
  { const std::shared_ptr<const Block> one_more = block; }
  return *std::const_pointer_cast<Block>(block);
}

void PlaceIndex::split(std::size_t at) {
  const auto lower = std::make_shared<Block>();
  const auto upper = std::make_shared<Block>();
  const Block& block = *blocks_[at];
  for (std::size_t slot = 0; slot < block.size(); ++slot) {
    Block& half = slot < block.size() / 2 ? *lower : *upper;
    half.insert(half.size(), block[slot], block.planes().get(slot));
  }
  blocks_[at] = lower;
  blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(at) + 1, upper);
}

bool PlaceIndex::erase(PlaceId id) {
  const std::size_t at = blockOf(id);
  if (at == blocks_.size() || !blocks_[at]->holds(id)) return false;
  Block& block = changeable(at);
  block.erase(block.slotOf(id));
  --size_;
  joinNext(at);
  if (at > 0) joinNext(at - 1);
  if (blocks_.size() == 1 && size_ == 0) blocks_.clear();
  return true;
}

void PlaceIndex::joinNext(std::size_t at) {
  if (at + 1 >= blocks_.size()) return;
  const Block& next = *blocks_[at + 1];
  if (blocks_[at]->size() + next.size() > kBlockSize) return;
  Block& block = changeable(at);
  for (std::size_t slot = 0; slot < next.size(); ++slot) {
    block.insert(block.size(), next[slot], next.planes().get(slot));
  }
  blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(at) + 1);
}

void PlaceIndex::clear() {
  blocks_.clear();
  size_ = 0;
}

}  // namespace place_memory::core
