#ifndef PLACE_MEMORY_CORE_MATCH_RESTART_SEARCH_H
#define PLACE_MEMORY_CORE_MATCH_RESTART_SEARCH_H

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/match/fixed_metric.h"
#include "core/match/place_looks.h"
#include "core/match/place_search.h"
#include "core/match/restarts.h"
#include "core/match/start_lattice.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// searchPlaces() by restarts: hill climbing for the places that may be the best ones. The first
/// look leaves out most of many places, the best starts of a close look most of the rest.
class RestartSearch {
 public:
  /// Keeps references to all of these. `poll` may throw.
  RestartSearch(const QueryPlanes& query, const PlaceIndex& places, const LatticeMetric& metric,
                const SearchWindow& window, const std::function<void()>& poll,
                support::WorkerPool& pool);

  std::vector<PlaceAlignment> run() const;

  /// How many have been made, in all runs.
  double evaluations() const { return static_cast<double>(rows_) / kGridSize; }

 private:
  struct Ranked {
    PlaceSlot place;
    Alignment alignment;
    Starts starts;
    std::vector<Alignment> summits;  ///< once climbed for; best first
    bool settled = false;
  };

  static bool isBetter(const Ranked* a, const Ranked* b);

  /// How many times as many a number becomes in a large memory; 1 in others.
  double timesMany(double growth) const;
  /// How many of all places, where it is `of_few` of a few.
  std::size_t grown(double of_few, double growth) const;
  /// How many places are climbed for at the least.
  std::size_t climbed() const;
  /// The best places, each at its best start.
  std::vector<Ranked> rank() const;
  void countLook(const StartLattice& lattice, std::size_t places) const;
  void countEvaluations(const Climber& climber) const;
  void lookClosely(const std::vector<Glimpse>& seen, std::vector<Ranked>& ranked) const;
  /// At the best starts that the first look showed; behind those that are ranked.
  void rankOthers(const StartLattice& lattice, const std::vector<Glimpse>& seen,
                  std::vector<Ranked>& ranked) const;
  void climb(const std::vector<Ranked*>& places) const;
  void settleSummits(const std::vector<Ranked*>& places) const;
  /// Sorts; climbs until the first are all climbed for and the very first are settled.
  void finish(std::vector<Ranked*>& ranked) const;

  const QueryPlanes& query_;
  const LatticeMetric& metric_;
  const SearchWindow& window_;
  const std::function<void()>& poll_;
  support::WorkerPool& pool_;
  FixedMetric fixed_;
  StartLattice lattice_;  ///< of the close look
  PlaceLooks looks_;
  std::size_t size_;
  mutable std::atomic<std::uint64_t> rows_{0};  ///< of grids that were compared
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_RESTART_SEARCH_H
