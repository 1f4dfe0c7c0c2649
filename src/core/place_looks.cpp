#include "place_looks.h"

#include <algorithm>
#include <array>

#include "coarse_planes.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kBlocksATask = 64;

}  // namespace

const PlaceBlock& PlaceLooks::blockOf(PlaceSlot place) const {
  return *places_.blocks()[place / PlaceIndex::kBlockSize];
}

const PlaceEntry& PlaceLooks::entryOf(PlaceSlot place) const {
  return blockOf(place)[place % PlaceIndex::kBlockSize];
}

CellPlanes PlaceLooks::cellsOf(PlaceSlot place) const {
  return blockOf(place).planes().get(place % PlaceIndex::kBlockSize);
}

std::vector<Glimpse> PlaceLooks::everyPlace() const {
  std::vector<Glimpse> seen;
  seen.reserve(places_.size());
  for (std::size_t i = 0; i < places_.blocks().size(); ++i) {
    for (std::size_t slot = 0; slot < places_.blocks()[i]->size(); ++slot) {
      seen.push_back({0, static_cast<PlaceSlot>(i * PlaceIndex::kBlockSize + slot), 0});
    }
  }
  return seen;
}

std::vector<Glimpse> PlaceLooks::lookFirst(const StartLattice& lattice) const {
  std::vector<Glimpse> seen = everyPlace();
  const auto& blocks = places_.blocks();
  std::vector<Glimpse*> of_block;
  Glimpse* next = seen.data();
  for (const auto& block : blocks) {
    of_block.push_back(next);
    next += block->size();
  }
  const auto look = [&](std::size_t task) {
    std::vector<BlockScores> scores;
    const std::size_t end = std::min(blocks.size(), (task + 1) * kBlocksATask);
    for (std::size_t i = task * kBlocksATask; i < end; ++i) {
      const BlockBest best = lattice.score(blocks[i]->coarsest().data(), scores);
      for (std::size_t slot = 0; slot < blocks[i]->size(); ++slot) {
        of_block[i][slot].score = best.score[slot] + metric_.ofPlace(blocks[i]->totals(slot));
        of_block[i][slot].start = static_cast<std::uint32_t>(best.transform[slot]);
      }
    }
  };
  pool_.run((blocks.size() + kBlocksATask - 1) / kBlocksATask, look, poll_);
  return seen;
}

void PlaceLooks::lookClosely(const StartLattice& lattice, Glimpse* begin, Glimpse* end) const {
  const auto look = [&](std::size_t task) {
    std::vector<BlockScores> scores;
    Glimpse* const first = begin + task * kBlockPlaces;
    Glimpse* const last = std::min(end, first + kBlockPlaces);
    const BlockBest best = scoreClosely(lattice, first, last, scores);
    for (Glimpse* glimpse = first; glimpse != last; ++glimpse) {
      const auto i = static_cast<std::size_t>(glimpse - first);
      const CellTotals& totals =
          blockOf(glimpse->place).totals(glimpse->place % PlaceIndex::kBlockSize);
      glimpse->score = best.score[i] + metric_.ofPlace(totals);
      glimpse->start = static_cast<std::uint32_t>(best.transform[i]);
    }
  };
  const auto places = static_cast<std::size_t>(end - begin);
  pool_.run((places + kBlockPlaces - 1) / kBlockPlaces, look, poll_);
}

BlockBest PlaceLooks::scoreClosely(const StartLattice& lattice, const Glimpse* begin,
                                   const Glimpse* end, std::vector<BlockScores>& scores) const {
  std::array<BlockRow, kCoarseRows> rows{};
  std::array<QueryRow, kCoarseRows> of_place;
  for (const Glimpse* glimpse = begin; glimpse != end; ++glimpse) {
    coarsen(cellsOf(glimpse->place), of_place.data());
    const auto i = static_cast<std::size_t>(glimpse - begin);
    for (std::size_t row = 0; row < kCoarseRows; ++row) {
      rows[row].occupied[i] = of_place[row].occupied;
      rows[row].empty[i] = of_place[row].empty;
    }
  }
  return lattice.score(rows.data(), scores);
}

}  // namespace place_memory::core
