#ifndef PLACE_MEMORY_CORE_MATCH_SEED_GRID_H
#define PLACE_MEMORY_CORE_MATCH_SEED_GRID_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/match/alignment_search.h"
#include "core/match/fixed_metric.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// How far apart seeds lie.
struct SeedSpacing {
  int cells;      ///< between neighbouring shifts
  int rotations;  ///< between neighbouring rotations [heading steps]
};

/// Screening leaves out most of very many places.
constexpr SeedSpacing kScreening{3, 4};
/// Seeding lies dense enough that climbs from the best few seeds miss little.
constexpr SeedSpacing kSeeding{2, 3};

/// What one place scores at a seed, in the fixed point of the metric.
struct ScoredSeed {
  std::int64_t score;
  std::uint32_t seed;
};

/// What a block of places scores at the seeds; used again and again, so that nothing is allocated.
struct SeedScores {
  std::vector<BlockBest> of_rotation;  ///< the best seed of each rotation
  std::vector<BlockScores> scratch;
};

/// The low-resolution level of correlative scan matching (Olson, Real-Time Correlative Scan
/// Matching, 2009) over seeds: the transforms of a search's window that climbs may start from.
/// Holds the recognition grid in 16 x 16 cells under each of them.
class SeedGrid {
 public:
  SeedGrid(const QueryPlanes& query, const FixedMetric& metric, const SearchWindow& window,
           const SeedSpacing& spacing, support::WorkerPool& pool);

  /// Number of seeds; at least 1.
  std::size_t size() const { return offsets_.size(); }
  std::size_t rotations() const { return rotations_; }
  /// Its transform; no score.
  Alignment seed(std::size_t index) const {
    Alignment alignment;
    alignment.shift.columns = coordinate(index % side_);
    alignment.shift.rows = coordinate(index / side_ % side_);
    alignment.rotation =
        first_rotation_ + static_cast<int>(index / (side_ * side_)) * spacing_.rotations;
    return alignment;
  }

  /// Scores a block of places at every seed, without what belongs to the place itself.
  void score(const CoarsestBlock& places, SeedScores& scores) const;

  /// The best seed of all rotations for one place of the scored block; of equal ones the first.
  ScoredSeed best(const SeedScores& scores, std::size_t place) const;

  /// The best seed of each rotation, of these the best `most`, by rising seed; at least one.
  void bestSeeds(const SeedScores& scores, std::size_t place, std::size_t most,
                 std::vector<ScoredSeed>& seeds) const;

 private:
  int coordinate(std::size_t index) const {
    return static_cast<int>(index) * spacing_.cells - most_cells_;
  }
  ScoredSeed seedOf(const SeedScores& scores, std::size_t rotation, std::size_t place) const;
  void prepare(const QueryPlanes& query, const FixedMetric& metric, std::size_t rotation);

  SeedSpacing spacing_;
  bool circular_;
  int first_rotation_;
  int most_cells_;
  std::size_t rotations_;  ///< number of them
  std::size_t side_;       ///< number of shifts along x, and along y
  PairFactors factors_;
  BlockKernel kernel_;
  std::vector<QueryRow> query_;  ///< kCoarsestRows for each seed
  std::vector<std::int64_t> offsets_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MATCH_SEED_GRID_H
