#include "place_memory/core/place_index.h"

#include <algorithm>

namespace place_memory::core {
namespace {

template <typename Entries>
auto firstNotBelow(Entries& entries, PlaceId id) {
  return std::lower_bound(
      entries.begin(), entries.end(), id,
      [](const PlaceIndex::Entry& entry, PlaceId key) { return entry.id < key; });
}

}  // namespace

std::size_t PlaceIndex::blockOf(PlaceId id) const {
  const auto block = std::lower_bound(
      blocks_.begin(), blocks_.end(), id,
      [](const std::shared_ptr<const Block>& b, PlaceId key) { return b->back().id < key; });
  return static_cast<std::size_t>(block - blocks_.begin());
}

void PlaceIndex::put(PlaceId id, const Pose2d& map_from_place, const EvidenceGrid& grid) {
  Entry entry{id, map_from_place, CellPlanes(grid)};
  std::size_t at = blockOf(id);
  if (at == blocks_.size() && at > 0 && blocks_.back()->size() < kBlockSize) --at;
  if (at == blocks_.size()) {
    blocks_.push_back(std::make_shared<const Block>(Block{entry}));
    ++size_;
    return;
  }
  auto changed = std::make_shared<Block>(*blocks_[at]);
  const auto place = firstNotBelow(*changed, id);
  if (place != changed->end() && place->id == id) {
    *place = entry;
    blocks_[at] = std::move(changed);
    return;
  }
  changed->insert(place, entry);
  ++size_;
  if (changed->size() > kBlockSize) {
    const auto middle = changed->begin() + kBlockSize / 2;
    auto upper = std::make_shared<const Block>(middle, changed->end());
    changed->erase(middle, changed->end());
    blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::move(upper));
  }
  blocks_[at] = std::move(changed);
}

bool PlaceIndex::erase(PlaceId id) {
  const std::size_t at = blockOf(id);
  if (at == blocks_.size()) return false;
  const auto found = firstNotBelow(*blocks_[at], id);
  if (found == blocks_[at]->end() || found->id != id) return false;
  auto changed = std::make_shared<Block>(*blocks_[at]);
  changed->erase(changed->begin() + (found - blocks_[at]->begin()));
  if (changed->empty()) {
    blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(at));
  } else {
    blocks_[at] = std::move(changed);
  }
  --size_;
  return true;
}

void PlaceIndex::clear() {
  blocks_.clear();
  size_ = 0;
}

}  // namespace place_memory::core
