#ifndef PLACE_MEMORY_CORE_MAPPING_PLACE_MATCHER_H
#define PLACE_MEMORY_CORE_MAPPING_PLACE_MATCHER_H

#include <Eigen/Core>
#include <unordered_map>
#include <vector>

#include "core/index/place_index.h"
#include "core/recognize/recognizer.h"
#include "place_memory/core/evidence_grid.h"

namespace place_memory::core {

/// One place of a map against a scan.
struct PlaceFit {
  PlaceId id = kNoPlace;
  double probability = 0.0;                                  ///< of the scan alone, in [0, 1]
  double score = 0.0;                                        ///< higher is better
  Pose2d place_from_scan;                                    ///< grid on grid
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of it, in the place's grid
};

/// What mapping asks of recognition; the only place from which it calls it.
class PlaceMatcher {
 public:
  explicit PlaceMatcher(const RecognizerOptions& options);

  void put(PlaceId id, const Pose2d& map_from_grid, const EvidenceGrid& grid);
  /// The same place at another pose.
  void move(PlaceId id, const Pose2d& map_from_grid);
  /// The places of another one too.
  void takeAll(const PlaceMatcher& other);
  bool erase(PlaceId id);
  std::size_t size() const { return index_.size(); }
  /// Of a place that is in the index.
  CellPlanes cells(PlaceId id) const { return index_.cells(id); }

  /// The few best of all places, best first. `heading_window` [rad].
  std::vector<PlaceFit> recognize(const EvidenceGrid& scan, double heading_window) const;

  /// The scan on one place, which is in the index.
  PlaceFit align(const EvidenceGrid& scan, PlaceId id, double heading_window) const;

 private:
  Recognizer recognizer_;
  PlaceIndex index_;
  std::unordered_map<PlaceId, Pose2d> frames_;  ///< where the grids lie
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_PLACE_MATCHER_H
