#include "core/index/place_block.h"

#include <algorithm>

#include "core/kernels/coarse_planes.h"
#include "core/kernels/popcount.h"

namespace place_memory::core {
namespace {

std::uint16_t countCells(const BitPlane& plane) {
  std::uint64_t cells = 0;
  for (const std::uint64_t row : plane) cells += PortablePopcount()(row);
  return static_cast<std::uint16_t>(cells);
}

}  // namespace

std::size_t PlaceBlock::slotOf(PlaceId id) const {
  return static_cast<std::size_t>(std::lower_bound(begin(), end(), id) - begin());
}

bool PlaceBlock::holds(PlaceId id) const {
  const std::size_t slot = slotOf(id);
  return slot < size_ && ids_[slot] == id;
}

void PlaceBlock::replace(std::size_t slot, PlaceId id, const CellPlanes& cells) {
  ids_[slot] = id;
  totals_[slot] = {countCells(cells.occupied), countCells(cells.empty)};
  planes_.set(slot, cells);
  std::array<QueryRow, kCoarsestRows> coarsest;
  coarsenMost(cells, coarsest.data());
  for (std::size_t row = 0; row < kCoarsestRows; ++row) {
    coarsest_[row].occupied[slot] = coarsest[row].occupied;
    coarsest_[row].empty[slot] = coarsest[row].empty;
  }
}

void PlaceBlock::insert(std::size_t slot, PlaceId id, const CellPlanes& cells) {
  for (std::size_t to = size_; to > slot; --to) {
    replace(to, ids_[to - 1], planes_.get(to - 1));
  }
  replace(slot, id, cells);
  ++size_;
}

void PlaceBlock::erase(std::size_t slot) {
  --size_;
  for (std::size_t to = slot; to < size_; ++to) {
    replace(to, ids_[to + 1], planes_.get(to + 1));
  }
  replace(size_, kNoPlace, {});
}

}  // namespace place_memory::core
