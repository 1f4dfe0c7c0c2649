#ifndef PLACE_MEMORY_CORE_RESTART_SEARCH_H
#define PLACE_MEMORY_CORE_RESTART_SEARCH_H

#include <functional>
#include <vector>

#include "fixed_metric.h"
#include "place_looks.h"
#include "place_search.h"
#include "restarts.h"
#include "start_lattice.h"
#include "worker_pool.h"

namespace place_memory::core {

/// searchPlaces() by restarts: hill climbing for the places that may be the best ones. The first
/// look leaves out most of many places, the close look most of the rest.
class RestartSearch {
 public:
  /// Keeps references to all of these. `poll` may throw.
  RestartSearch(const QueryPlanes& query, const PlaceIndex& places, const LatticeMetric& metric,
                const SearchWindow& window, const std::function<void()>& poll, WorkerPool& pool);

  std::vector<PlaceAlignment> run() const;

 private:
  struct Ranked {
    Glimpse glimpse;
    Alignment alignment;
    std::vector<Alignment> summits;  ///< once climbed for; best first
    bool settled = false;
  };

  /// The places that are looked at closely.
  std::vector<Glimpse> shortlist() const;
  /// The best places of all that were `seen`, in any order: climbed for, or as the close look shows
  /// them.
  std::vector<Ranked> rank(const StartLattice& lattice, std::vector<Glimpse>& seen) const;
  /// At the best starts of a look.
  void rankUnclimbed(const StartLattice& lattice, const Glimpse* begin, const Glimpse* end,
                     std::vector<Ranked>& ranked) const;
  void climb(const StartLattice& lattice, const std::vector<Ranked*>& places) const;
  void settleSummits(const std::vector<Ranked*>& places) const;
  /// Sorts; climbs on until the first are all climbed for and the very first are settled.
  void finish(const StartLattice& lattice, std::vector<Ranked>& ranked) const;

  const QueryPlanes& query_;
  const LatticeMetric& metric_;
  const SearchWindow& window_;
  const std::function<void()>& poll_;
  WorkerPool& pool_;
  FixedMetric fixed_;
  PlaceLooks looks_;
  std::size_t size_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RESTART_SEARCH_H
