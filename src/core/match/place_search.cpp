#include "core/match/place_search.h"

#include <algorithm>
#include <stdexcept>

#include "core/match/restart_search.h"

namespace place_memory::core {
namespace {

/// So few places are not worth waking other threads for; for restarts, so few places times
/// rotations.
constexpr std::size_t kFew = 32;
constexpr std::size_t kFewRotations = 2000;

std::vector<PlaceAlignment> alignEach(const QueryPlanes& query, const PlaceIndex& places,
                                      const LatticeMetric& metric, const SearchWindow& window,
                                      SearchMethod method, const std::function<void()>& poll,
                                      support::WorkerPool& pool) {
  const auto& blocks = places.blocks();
  std::vector<std::vector<PlaceAlignment>> found(blocks.size());
  pool.run(
      blocks.size(),
      [&](std::size_t i) {
        const PlaceBlock& block = *blocks[i];
        for (std::size_t slot = 0; slot < block.size(); ++slot) {
          const CellPlanes cells = block.planes().get(slot);
          found[i].push_back({block[slot], findAlignment(query, cells, metric, window, method)});
        }
      },
      poll);
  std::vector<PlaceAlignment> all;
  all.reserve(places.size());
  for (const auto& of_block : found) all.insert(all.end(), of_block.begin(), of_block.end());
  std::stable_sort(all.begin(), all.end(), [](const PlaceAlignment& a, const PlaceAlignment& b) {
    return a.alignment.score > b.alignment.score;
  });
  if (all.size() > kMostRanked) all.resize(kMostRanked);
  return all;
}

}  // namespace

std::vector<PlaceAlignment> searchPlaces(const QueryPlanes& query, const PlaceIndex& places,
                                         const LatticeMetric& metric, const SearchWindow& window,
                                         SearchMethod method,
                                         const std::function<bool()>& cancelled,
                                         support::WorkerPool& pool, SearchEffort* effort) {
  // Of the type that the search keeps a reference to.
  const std::function<void()> poll = [&cancelled] {
    if (cancelled && cancelled()) throw std::runtime_error("recognition was cancelled");
  };
  support::WorkerPool alone(1);
  if (method == SearchMethod::kRestarts) {
    const auto rotations = static_cast<std::size_t>(2 * window.rotations + 1);
    const bool shares = places.size() * rotations > kFewRotations;
    const RestartSearch search(query, places, metric, window, poll, shares ? pool : alone);
    std::vector<PlaceAlignment> found = search.run();
    if (effort) effort->evaluations = search.evaluations();
    return found;
  }
  const bool shares = places.size() > kFew;
  return alignEach(query, places, metric, window, method, poll, shares ? pool : alone);
}

}  // namespace place_memory::core
