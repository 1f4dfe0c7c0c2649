#ifndef PLACE_MEMORY_CORE_START_LATTICE_H
#define PLACE_MEMORY_CORE_START_LATTICE_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fixed_metric.h"
#include "place_memory/core/alignment_search.h"
#include "worker_pool.h"

namespace place_memory::core {

/// How closely a search first looks.
struct Look {
  int cells;         ///< between the shifts it tries
  int turns;         ///< between the turns it tries
  std::size_t rows;  ///< of the coarse planes that it compares
  /// Makes them, one shift after the other.
  void (*coarsen)(const CellPlanes& cells, const std::vector<CellShift>& shifts, QueryRow* rows);
  PairShares shares;
};

/// Over 32 x 32 cells, close enough that climbs from the best few starts miss little.
extern const Look kCloseLook;
/// Over 16 x 16 cells, to leave out most of very many places.
extern const Look kFirstLook;

/// The recognition grid under the transforms of a search's window that climbs may start from.
class StartLattice {
 public:
  StartLattice(const QueryPlanes& query, const FixedMetric& metric, const SearchWindow& window,
               const Look& look, WorkerPool& pool);

  /// Number of starts; at least 1.
  std::size_t size() const { return offsets_.size(); }
  /// Its transform; no score.
  Alignment start(std::size_t index) const;
  std::size_t rows() const { return look_.rows; }

  /// What each place of a block scores at each start, in the fixed point of the metric, beside what
  /// belongs to the place: scores[start][place]; and the best start of each. `places`: rows()
  /// coarse rows.
  BlockBest score(const BlockRow* places, std::vector<BlockScores>& scores) const;

  /// The best start of each turn, of these the best `most`, best first; at least one.
  std::vector<Alignment> bestStarts(const std::vector<BlockScores>& scores, std::size_t place,
                                    std::size_t most) const;

 private:
  const Look& look_;
  bool circular_;
  int first_turn_;
  int most_cells_;
  std::size_t turns_;  ///< number of them
  std::size_t side_;   ///< number of shifts along x, and along y
  PairFactors factors_;
  BlockKernel kernel_;
  std::vector<QueryRow> query_;  ///< rows() for each start
  std::vector<std::int64_t> offsets_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_START_LATTICE_H
