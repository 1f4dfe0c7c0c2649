#ifndef PLACE_MEMORY_CORE_CLIMBER_H
#define PLACE_MEMORY_CORE_CLIMBER_H

#include <vector>

#include "linear_metric.h"
#include "place_memory/core/alignment_search.h"

namespace place_memory::core {

/// Searches the alignments with one learned grid, each once. Keeps references to all it is made of.
class Climber {
 public:
  Climber(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
          const SearchWindow& window);

  Alignment evaluate(CellShift shift, int turn) const;

  /// Climbs from a transform of the window: moves by `first_step` cells or turns while that scores
  /// higher, then by half of it, and so on to single ones (paper 4). Where another climb has been
  /// is not climbed again.
  void climb(CellShift shift, int turn, int first_step);

  /// Tries all alignments near a summit, and climbs on from better ones. A turn about the grid's
  /// centre moves what the robot saw to one side, so ridges run aslant and summits lie close
  /// together along them.
  void settle(const Alignment& summit);

  /// What climbs have reached, best first.
  std::vector<Alignment> summits() const;

 private:
  Alignment climbFrom(Alignment from, int first_step);
  bool stepUp(int step, Alignment& at);
  /// Takes it where it lies in the window, is tried for the first time, and scores higher.
  void tryAlignment(CellShift shift, int turn, Alignment& at);
  /// Whether it has not been tried before.
  bool isNew(CellShift shift, int turn);

  const QueryPlanes& query_;
  const CellPlanes& learned_;
  const LatticeMetric& metric_;
  const SearchWindow& window_;
  LinearMetric linear_;
  double of_place_;
  std::vector<bool> tried_;  ///< of all transforms in the window, once a climb has begun
  std::vector<Alignment> summits_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_CLIMBER_H
