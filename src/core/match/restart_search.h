#ifndef PLACE_MEMORY_CORE_MATCH_RESTART_SEARCH_H
#define PLACE_MEMORY_CORE_MATCH_RESTART_SEARCH_H

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/match/fixed_metric.h"
#include "core/match/place_screening.h"
#include "core/match/place_search.h"
#include "core/match/restarts.h"
#include "core/match/seed_grid.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// searchPlaces() by restarts: hill climbing for the places that may be the best ones. Screening
/// leaves out most of many places, what they score at their best seeds most of the rest.
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
    Seeds seeds;
    std::vector<Alignment> summits;  ///< once climbed for; best first
    bool refined = false;
  };

  static bool isBetter(const Ranked* a, const Ranked* b);

  /// How many times as many a number becomes in a large memory; 1 in others.
  double timesMany(double growth) const;
  /// How many of all places, where it is `of_few` of a few.
  std::size_t grown(double of_few, double growth) const;
  /// How many places are climbed for at the least.
  std::size_t climbed() const;
  /// The best places, each at its best seed.
  std::vector<Ranked> rank() const;
  void countScreening(const SeedGrid& grid, std::size_t places) const;
  void countEvaluations(const Climber& climber) const;
  /// Ranks the places by the best of their seeds.
  void seedPlaces(const std::vector<ScreenedPlace>& screened, std::vector<Ranked>& ranked) const;
  /// At the best seeds that screening found; behind those that are ranked.
  void rankOthers(const SeedGrid& grid, const std::vector<ScreenedPlace>& screened,
                  std::vector<Ranked>& ranked) const;
  void climb(const std::vector<Ranked*>& places) const;
  void refineSummits(const std::vector<Ranked*>& places) const;
  /// Sorts; climbs until the first are all climbed for and the very first are refined.
  void finish(std::vector<Ranked*>& ranked) const;

  const QueryPlanes& query_;
  const LatticeMetric& metric_;
  const SearchWindow& window_;
  const std::function<void()>& poll_;
  support::WorkerPool& pool_;
  FixedMetric fixed_;
  SeedGrid seed_grid_;  ///< of seeding
  PlaceScreening screening_;
  std::size_t size_;
  mutable std::atomic<std::uint64_t> rows_{0};  ///< of grids that were compared
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_RESTART_SEARCH_H
