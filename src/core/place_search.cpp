#include "place_search.h"

#include <algorithm>
#include <stdexcept>

namespace place_memory::core {

std::vector<PlaceAlignment> searchPlaces(const QueryPlanes& query, const PlaceIndex& places,
                                         const LatticeMetric& metric, const SearchWindow& window,
                                         SearchMethod method,
                                         const std::function<bool()>& cancelled) {
  std::vector<PlaceAlignment> all;
  all.reserve(places.size());
  for (const auto& block : places.blocks()) {
    if (cancelled && cancelled()) throw std::runtime_error("recognition was cancelled");
    for (std::size_t slot = 0; slot < block->size(); ++slot) {
      const CellPlanes cells = block->planes().get(slot);
      all.push_back({&(*block)[slot], findAlignment(query, cells, metric, window, method)});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const PlaceAlignment& a, const PlaceAlignment& b) {
    return a.alignment.score > b.alignment.score;
  });
  return all;
}

}  // namespace place_memory::core
