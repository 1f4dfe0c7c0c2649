#ifndef PLACE_MEMORY_CORE_MATCH_START_LATTICE_H
#define PLACE_MEMORY_CORE_MATCH_START_LATTICE_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/match/alignment_search.h"
#include "core/match/fixed_metric.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// How closely starts lie.
struct Look {
  int cells;  ///< between shifts
  int turns;  ///< between turns
};

/// To leave out most of very many places.
constexpr Look kFirstLook{3, 4};
/// Close enough that climbs from the best few starts miss little.
constexpr Look kCloseLook{2, 3};

/// What one place scores at a start, in the fixed point of the metric.
struct ScoredStart {
  std::int64_t score;
  std::uint32_t start;
};

/// What a look at a block of places showed; used again and again, so that nothing is allocated.
struct LookScores {
  std::vector<BlockBest> of_turn;  ///< the best start of each turn
  std::vector<BlockScores> scratch;
};

/// The recognition grid in 16 x 16 cells, under the transforms of a search's window that climbs may
/// start from.
class StartLattice {
 public:
  StartLattice(const QueryPlanes& query, const FixedMetric& metric, const SearchWindow& window,
               const Look& look, support::WorkerPool& pool);

  /// Number of starts; at least 1.
  std::size_t size() const { return offsets_.size(); }
  std::size_t turns() const { return turns_; }
  /// Its transform; no score.
  Alignment start(std::size_t index) const {
    Alignment alignment;
    alignment.shift.columns = coordinate(index % side_);
    alignment.shift.rows = coordinate(index / side_ % side_);
    alignment.turn = first_turn_ + static_cast<int>(index / (side_ * side_)) * look_.turns;
    return alignment;
  }

  /// Looks at a block of places; scores are beside what belongs to the place.
  void look(const CoarsestBlock& places, LookScores& scores) const;

  /// The best start of all turns for one place of the block that was looked at; of equal ones the
  /// first.
  ScoredStart best(const LookScores& scores, std::size_t place) const;

  /// The best start of each turn, of these the best `most`, by rising start; at least one.
  void bestStarts(const LookScores& scores, std::size_t place, std::size_t most,
                  std::vector<ScoredStart>& starts) const;

 private:
  int coordinate(std::size_t index) const {
    return static_cast<int>(index) * look_.cells - most_cells_;
  }
  ScoredStart startOf(const LookScores& scores, std::size_t turn, std::size_t place) const;
  void prepare(const QueryPlanes& query, const FixedMetric& metric, std::size_t turn);

  Look look_;
  bool circular_;
  int first_turn_;
  int most_cells_;
  std::size_t turns_;  ///< number of them
  std::size_t side_;   ///< number of shifts along x, and along y
  PairFactors factors_;
  BlockKernel kernel_;
  std::vector<QueryRow> query_;  ///< kCoarsestRows for each start
  std::vector<std::int64_t> offsets_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_START_LATTICE_H
