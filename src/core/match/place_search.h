#ifndef PLACE_MEMORY_CORE_MATCH_PLACE_SEARCH_H
#define PLACE_MEMORY_CORE_MATCH_PLACE_SEARCH_H

#include <cstddef>
#include <functional>
#include <vector>

#include "core/index/place_index.h"
#include "core/match/alignment_search.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// A place at the best alignment that was found for it.
struct PlaceAlignment {
  PlaceId place;
  Alignment alignment;
};

/// Of more places than these, searchPlaces() returns the best ones.
constexpr std::size_t kMostRanked = 1024;
/// So many of the best places have been climbed for from all their seeds.
constexpr std::size_t kSurelyClimbed = 12;

/// What a search took, in evaluations: one is a transform of a place, cell by cell. Over coarse
/// cells it counts as what part of the rows is compared.
struct SearchEffort {
  double evaluations = 0.0;
};

/// Aligns the recognition grid with the places, and returns them by falling score; places that
/// score the same, by rising id. All methods but restarts align every place fully. Restarts
/// screen all places over coarse cells first, seed the better ones, and climb for the best; what
/// the others score is that of the best seed that was found. The answer does not depend on the
/// pool. `cancelled`, where given, is polled by the caller's thread between blocks of places; once
/// it returns true the call throws std::runtime_error. `effort`, where given, is set to what
/// restarts took; other methods leave it as it is.
std::vector<PlaceAlignment> searchPlaces(const QueryPlanes& query, const PlaceIndex& places,
                                         const LatticeMetric& metric, const SearchWindow& window,
                                         SearchMethod method,
                                         const std::function<bool()>& cancelled,
                                         support::WorkerPool& pool, SearchEffort* effort = nullptr);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_PLACE_SEARCH_H
