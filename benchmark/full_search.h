#ifndef PLACE_MEMORY_BENCHMARK_FULL_SEARCH_H
#define PLACE_MEMORY_BENCHMARK_FULL_SEARCH_H

#include <cstdint>
#include <vector>

#include "core/block_kernel.h"
#include "place_memory/core/alignment_search.h"
#include "place_memory/core/place_index.h"

namespace place_memory::measure {

/// A place and what the best of its transforms scores.
struct ScoredPlace {
  core::PlaceId id = core::kNoPlace;
  double score = 0.0;
};

/// Exactly what trying every transform of the window for every place finds, a hundred times as
/// fast: shifts are taken three by three along both axes, and a bound for all nine of them tells
/// whether any can be the best. The bound counts what is good wherever one of the nine has it, and
/// what is bad only where all of them have it.
class FullSearch {
 public:
  /// Keeps a reference to the planes. Throws std::invalid_argument where the metric counts pairs of
  /// overlapping cells only: the bounds do not hold for it.
  FullSearch(const core::QueryPlanes& query, const core::LatticeMetric& metric,
             const core::SearchWindow& window);

  /// The best place; of equal ones the one with the lowest id. `known` is a place that was found by
  /// other means, with a score that it has in truth: what cannot beat it is not looked at.
  ScoredPlace best(const core::PlaceIndex& places, const ScoredPlace& known) const;

 private:
  struct Group {
    int turn;
    int first_column, first_row;
  };

  template <typename Call>
  void forEachShift(const Group& group, const Call& call) const;
  void addGroup(const Group& group);
  core::KernelInput inputOf(const core::PlaceBlock& block, std::size_t first_group,
                            std::size_t groups) const;
  /// Looks at some places; `best` is the best one up to then.
  void search(const core::PlaceIndex& places, std::size_t first_block, std::size_t last_block,
              ScoredPlace& best) const;
  void searchGroup(const core::PlaceBlock& block, std::size_t group,
                   const core::BlockScores& bounds, ScoredPlace& best) const;
  /// What a place's cells count for whatever the transform.
  double termOf(const core::CellTotals& totals) const;

  const core::QueryPlanes& query_;
  core::LatticeMetric metric_;
  core::SearchWindow window_;
  core::PairFactors good_{};  ///< the factors above zero, rounded up
  core::PairFactors bad_{};   ///< the others, rounded up
  core::BlockKernel kernel_ = core::fastestBlockKernel();
  std::vector<Group> groups_;
  std::vector<core::QueryRow> somewhere_;   ///< 64 rows a group: set for one of its transforms
  std::vector<core::QueryRow> everywhere_;  ///< set for all of its transforms
  std::vector<std::int64_t> offsets_;       ///< the best of its transforms, places aside
};

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_FULL_SEARCH_H
