#include "core/recognize/scan_query.h"

#include "core/match/alignment_search.h"

namespace place_memory::core {
namespace {

SearchWindow windowOf(const RecognizerOptions& options, double heading_window, double cell_size) {
  if (options.method == SearchMethod::kNearestNeighbour) return {};
  return searchWindow(options.position_window, heading_window, cell_size);
}

}  // namespace

ScanQuery::ScanQuery(const EvidenceGrid& grid, const RecognizerOptions& options,
                     double heading_window)
    : options_(options),
      cell_size_(grid.geometry().cell_size),
      window_(windowOf(options, heading_window, cell_size_)),
      metric_(onLattice(options.metric, window_, cell_size_)),
      planes_(grid, kHeadingStep, window_.rotations) {}

std::vector<PlaceAlignment> ScanQuery::alignAll(const PlaceIndex& places,
                                                const std::function<bool()>& cancelled,
                                                support::WorkerPool& pool) const {
  return searchPlaces(planes_, places, metric_, window_, options_.method, cancelled, pool);
}

Alignment ScanQuery::align(const CellPlanes& learned) const {
  return findAlignment(planes_, learned, metric_, window_, options_.method);
}

PairCounts ScanQuery::ownPairs() const {
  const CellPlanes& own = planes_.at(0);
  return countPairs(own, {0, 0}, own);
}

AlignmentCounts ScanQuery::countsAt(const Alignment& at, const CellPlanes& learned) const {
  const CellPlanes& rotated = planes_.at(at.rotation);
  return {countPairs(rotated, at.shift, learned), countForRescoring(rotated, at.shift, learned),
          peakSharpness(planes_, learned, metric_, window_, at)};
}

Pose2d ScanQuery::poseOf(const Alignment& alignment) const {
  return {alignment.shift.columns * cell_size_, alignment.shift.rows * cell_size_,
          wrapAngle(alignment.rotation * kHeadingStep)};
}

PoseEstimate ScanQuery::estimate(const Alignment& best, const CellPlanes& learned) const {
  return estimatePose(planes_, learned, metric_, window_, best, cell_size_,
                      options_.calibration.sharpness);
}

}  // namespace place_memory::core
