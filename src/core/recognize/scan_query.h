#ifndef PLACE_MEMORY_CORE_RECOGNIZE_SCAN_QUERY_H
#define PLACE_MEMORY_CORE_RECOGNIZE_SCAN_QUERY_H

#include <functional>
#include <vector>

#include "core/index/place_index.h"
#include "core/match/lattice.h"
#include "core/match/place_search.h"
#include "core/match/query_planes.h"
#include "core/recognize/pose_estimate.h"
#include "core/recognize/rescoring.h"
#include "place_memory/core/recognizer_options.h"
#include "support/worker_pool.h"

namespace place_memory::core {

/// What a scan and a learned grid have in common at an alignment.
struct AlignmentCounts {
  PairCounts pairs{};
  RescoringCounts near;
  PeakSharpness sharpness;
};

/// A scan's grid made ready to be aligned with places, in the window of one search.
class ScanQuery {
 public:
  /// `options` outlives this. `heading_window` in [0, pi] [rad].
  ScanQuery(const EvidenceGrid& grid, const RecognizerOptions& options, double heading_window);

  const QueryPlanes& planes() const { return planes_; }
  const SearchWindow& window() const { return window_; }
  const LatticeMetric& metric() const { return metric_; }
  double cellSize() const { return cell_size_; }  ///< [m]

  /// searchPlaces() by the method of the options.
  std::vector<PlaceAlignment> alignAll(const PlaceIndex& places,
                                       const std::function<bool()>& cancelled,
                                       support::WorkerPool& pool) const;
  /// findAlignment() by the method of the options.
  Alignment align(const CellPlanes& learned) const;

  /// Of the scan with itself.
  PairCounts ownPairs() const;
  AlignmentCounts countsAt(const Alignment& at, const CellPlanes& learned) const;

  /// The pose of the scan in the place that the alignment stands for.
  Pose2d poseOf(const Alignment& alignment) const;
  /// The same between the lattice's points, and how sure it is.
  PoseEstimate estimate(const Alignment& best, const CellPlanes& learned) const;

 private:
  const RecognizerOptions& options_;
  double cell_size_;
  SearchWindow window_;
  LatticeMetric metric_;
  QueryPlanes planes_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_SCAN_QUERY_H
