#include "core/match/place_looks.h"

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr std::size_t kBlocksATask = 32;

}  // namespace

const PlaceBlock& PlaceLooks::blockOf(PlaceSlot place) const {
  return *places_.blocks()[place / PlaceIndex::kBlockSize];
}

PlaceId PlaceLooks::idOf(PlaceSlot place) const {
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

std::vector<Glimpse> PlaceLooks::lookAtAll(const StartLattice& lattice) const {
  std::vector<Glimpse> seen = everyPlace();
  const auto& blocks = places_.blocks();
  std::vector<Glimpse*> of_block;
  Glimpse* next = seen.data();
  for (const auto& block : blocks) {
    of_block.push_back(next);
    next += block->size();
  }
  const auto look = [&](std::size_t task) {
    LookScores scores;
    const std::size_t end = std::min(blocks.size(), (task + 1) * kBlocksATask);
    for (std::size_t i = task * kBlocksATask; i < end; ++i) {
      lattice.look(blocks[i]->coarsest(), scores);
      for (std::size_t slot = 0; slot < blocks[i]->size(); ++slot) {
        const ScoredStart best = lattice.best(scores, slot);
        of_block[i][slot].score = best.score + metric_.ofPlace(blocks[i]->totals(slot));
        of_block[i][slot].start = best.start;
      }
    }
  };
  pool_.run((blocks.size() + kBlocksATask - 1) / kBlocksATask, look, poll_);
  return seen;
}

void PlaceLooks::look(const StartLattice& lattice, const Glimpse* begin, const Glimpse* end,
                      LookScores& scores) const {
  CoarsestBlock rows{};
  for (const Glimpse* glimpse = begin; glimpse != end; ++glimpse) {
    const CoarsestBlock& from = blockOf(glimpse->place).coarsest();
    const std::size_t slot = glimpse->place % PlaceIndex::kBlockSize;
    const auto i = static_cast<std::size_t>(glimpse - begin);
    for (std::size_t row = 0; row < kCoarsestRows; ++row) {
      rows[row].occupied[i] = from[row].occupied[slot];
      rows[row].empty[i] = from[row].empty[slot];
    }
  }
  lattice.look(rows, scores);
}

}  // namespace place_memory::core
