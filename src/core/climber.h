#ifndef PLACE_MEMORY_CORE_CLIMBER_H
#define PLACE_MEMORY_CORE_CLIMBER_H

#include "place_memory/core/alignment_search.h"

namespace place_memory::core {

/// Evaluates alignments with one learned grid, and climbs to better ones. Keeps references to all
/// it is made of.
class Climber {
 public:
  Climber(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
          const SearchWindow& window)
      : query_(query), counter_(learned), metric_(metric), window_(window) {}

  Alignment evaluate(CellShift shift, int turn) const;

  /// Moves by `first_step` cells or turns while that scores higher, then by half of it, and so on
  /// to single ones (paper 4).
  Alignment climb(Alignment from, int first_step) const;

  /// Tries all alignments near a summit, and climbs on from better ones. A turn about the grid's
  /// centre moves what the robot saw to one side, so ridges run aslant and summits lie close
  /// together along them.
  Alignment settle(Alignment summit) const;

 private:
  bool stepUp(int step, Alignment& best) const;
  void tryAlignment(CellShift shift, int turn, Alignment& best) const;

  const QueryPlanes& query_;
  PairCounter counter_;
  const LatticeMetric& metric_;
  const SearchWindow& window_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_CLIMBER_H
