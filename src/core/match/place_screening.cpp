#include "core/match/place_screening.h"

#include <algorithm>

namespace place_memory::core {
namespace {

constexpr std::size_t kBlocksATask = 32;

}  // namespace

const PlaceBlock& PlaceScreening::blockOf(PlaceSlot place) const {
  return *places_.blocks()[place / PlaceIndex::kBlockSize];
}

PlaceId PlaceScreening::idOf(PlaceSlot place) const {
  return blockOf(place)[place % PlaceIndex::kBlockSize];
}

CellPlanes PlaceScreening::cellsOf(PlaceSlot place) const {
  return blockOf(place).planes().get(place % PlaceIndex::kBlockSize);
}

std::vector<ScreenedPlace> PlaceScreening::everyPlace() const {
  std::vector<ScreenedPlace> screened;
  screened.reserve(places_.size());
  for (std::size_t i = 0; i < places_.blocks().size(); ++i) {
    for (std::size_t slot = 0; slot < places_.blocks()[i]->size(); ++slot) {
      screened.push_back({0, static_cast<PlaceSlot>(i * PlaceIndex::kBlockSize + slot), 0});
    }
  }
  return screened;
}

std::vector<ScreenedPlace> PlaceScreening::screenAll(const SeedGrid& grid) const {
  std::vector<ScreenedPlace> screened = everyPlace();
  const auto& blocks = places_.blocks();
  std::vector<ScreenedPlace*> of_block;
  ScreenedPlace* next = screened.data();
  for (const auto& block : blocks) {
    of_block.push_back(next);
    next += block->size();
  }
  const auto screen = [&](std::size_t task) {
    SeedScores scores;
    const std::size_t end = std::min(blocks.size(), (task + 1) * kBlocksATask);
    for (std::size_t i = task * kBlocksATask; i < end; ++i) {
      grid.score(blocks[i]->coarsest(), scores);
      for (std::size_t slot = 0; slot < blocks[i]->size(); ++slot) {
        const ScoredSeed best = grid.best(scores, slot);
        of_block[i][slot].score = best.score + metric_.ofPlace(blocks[i]->totals(slot));
        of_block[i][slot].seed = best.seed;
      }
    }
  };
  pool_.run((blocks.size() + kBlocksATask - 1) / kBlocksATask, screen, poll_);
  return screened;
}

void PlaceScreening::score(const SeedGrid& grid, const ScreenedPlace* begin,
                           const ScreenedPlace* end, SeedScores& scores) const {
  CoarsestBlock rows{};
  for (const ScreenedPlace* place = begin; place != end; ++place) {
    const CoarsestBlock& from = blockOf(place->place).coarsest();
    const std::size_t slot = place->place % PlaceIndex::kBlockSize;
    const auto i = static_cast<std::size_t>(place - begin);
    for (std::size_t row = 0; row < kCoarsestRows; ++row) {
      rows[row].occupied[i] = from[row].occupied[slot];
      rows[row].empty[i] = from[row].empty[slot];
    }
  }
  grid.score(rows, scores);
}

}  // namespace place_memory::core
