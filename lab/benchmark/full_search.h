#ifndef PLACE_MEMORY_BENCHMARK_FULL_SEARCH_H
#define PLACE_MEMORY_BENCHMARK_FULL_SEARCH_H

#include <cstdint>
#include <vector>

#include "core/index/place_index.h"
#include "core/kernels/block_kernel.h"
#include "core/match/alignment_search.h"

namespace place_memory::measure {

/// A place and what the best of its transforms scores.
struct ScoredPlace {
  core::PlaceId id = core::kNoPlace;
  double score = 0.0;
};

/// Exactly what trying every transform of the window for every place finds, hundreds of times as
/// fast: transforms are taken in groups, three shifts along both axes by six rotations, and a bound
/// for all of a group tells whether any can be the best; where one can, a bound for each rotation.
/// A bound counts what is good wherever a transform of the group has it, and what is bad only where
/// all of them have it.
class FullSearch {
 public:
  /// Keeps a reference to the planes. Throws std::invalid_argument where the metric counts pairs of
  /// overlapping cells only: the bounds do not hold for it.
  FullSearch(const core::QueryPlanes& query, const core::LatticeMetric& metric,
             const core::SearchWindow& window);

  /// The best place; of equal ones the one with the lowest id. `known` is a place that was found by
  /// other means, with a score that it has in truth: what cannot beat it is left out.
  ScoredPlace best(const core::PlaceIndex& places, const ScoredPlace& known) const;

 private:
  struct Group {
    int first_rotation, last_rotation;
    int first_column, first_row;
  };

  /// What the bounds of groups are made from.
  struct Groups {
    std::vector<Group> all;
    std::vector<core::QueryRow> somewhere;   ///< 64 rows a group: set for one of its transforms
    std::vector<core::QueryRow> everywhere;  ///< set for all of its transforms
    std::vector<std::int64_t> offsets;       ///< the best of its transforms, places aside
  };

  template <typename Call>
  void forEachTransform(const Group& group, const Call& call) const;
  void add(const Group& group, Groups& groups) const;
  /// Searches some places; `best` is the best one up to then.
  void search(const core::PlaceIndex& places, std::size_t first_block, std::size_t last_block,
              ScoredPlace& best) const;
  void searchGroup(const core::PlaceBlock& block, std::size_t group,
                   const core::BlockScores& bounds, ScoredPlace& best) const;
  void tryTransforms(const core::PlaceBlock& block, std::size_t slot, const Group& group,
                     ScoredPlace& best) const;
  bool mayBeBest(std::int64_t bound, const core::CellTotals& totals, const ScoredPlace& best) const;
  /// What a place's cells count for whatever the transform.
  double termOf(const core::CellTotals& totals) const;

  const core::QueryPlanes& query_;
  core::LatticeMetric metric_;
  core::SearchWindow window_;
  core::PairFactors good_{};  ///< the factors above zero, rounded up
  core::PairFactors bad_{};   ///< the others, rounded up
  core::BlockKernel kernel_ = core::chosenKernel(core::blockKernels());
  Groups coarse_;                        ///< several rotations each
  Groups fine_;                          ///< one rotation each
  std::vector<std::size_t> first_fine_;  ///< of each coarse group, and one past the last
};

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_FULL_SEARCH_H
