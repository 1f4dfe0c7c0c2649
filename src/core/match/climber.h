#ifndef PLACE_MEMORY_CORE_MATCH_CLIMBER_H
#define PLACE_MEMORY_CORE_MATCH_CLIMBER_H

#include <cstddef>
#include <vector>

#include "core/kernels/transform_kernel.h"
#include "core/match/alignment_search.h"
#include "core/match/linear_metric.h"

namespace place_memory::core {

/// Searches the alignments with one learned grid, each once. Keeps references to all it is made of.
class Climber {
 public:
  Climber(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
          const SearchWindow& window);

  Alignment evaluate(CellShift shift, int rotation) const;
  /// Sets what each of them scores; many at once are faster than one by one.
  void evaluate(Alignment* begin, std::size_t size) const;

  /// How many transforms have been evaluated.
  std::size_t evaluations() const { return evaluations_; }

  /// Steepest-ascent hill climbing (paper 4) from a transform of the window: moves by `first_step`
  /// cells or heading steps while that scores higher, then by half of it, and so on to single ones.
  /// Where another climb has been is not climbed again.
  void climb(CellShift shift, int rotation, int first_step);

  /// Tries all alignments near a summit, and climbs on from better ones. A rotation about the
  /// grid's centre moves what the robot saw to one side, so ridges run aslant and summits lie close
  /// together along them.
  void refine(const Alignment& summit);

  /// What climbs have reached, best first.
  std::vector<Alignment> summits() const;

 private:
  double cost(const Alignment& at) const;
  double overlapScore(const Alignment& at) const;
  double score(const PlaneCounts& counts) const;
  void begin();
  Alignment climbFrom(Alignment from, int first_step);
  bool stepUp(int step, Alignment& at);
  /// Keeps it to be tried where it lies in the window and has not been tried before.
  void propose(CellShift shift, int rotation);
  /// Evaluates what was proposed; takes the best of them where it scores higher, of equal ones the
  /// first.
  void takeBest(Alignment& at);
  /// Whether it has not been tried before.
  bool isNew(CellShift shift, int rotation);

  const QueryPlanes& query_;
  const CellPlanes& learned_;
  const LatticeMetric& metric_;
  const SearchWindow& window_;
  LinearMetric linear_;
  double of_place_;
  std::vector<bool> tried_;  ///< of all transforms in the window, once a climb has begun
  mutable std::size_t evaluations_ = 0;
  std::vector<Alignment> proposed_;
  std::vector<Alignment> summits_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_CLIMBER_H
