#ifndef PLACE_MEMORY_CORE_RECOGNIZE_HYPOTHESIS_CLUSTER_H
#define PLACE_MEMORY_CORE_RECOGNIZE_HYPOTHESIS_CLUSTER_H

#include <cstddef>
#include <optional>
#include <vector>

#include "core/recognize/place_frame.h"
#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// A pose hypothesis: where one place's alignment puts the robot.
struct PoseHypothesis {
  double score = 0.0;
  double shift = 0.0;  ///< of the alignment: how far from the place the robot would stand [m]
  /// The pose of the scan frame that follows; none: where the place lies is not known, and it
  /// contradicts every other.
  std::optional<Pose2d> map_from_scan;
  SessionId session = 1;  ///< in whose frame that is
};

/// So many hypotheses are clustered at the most.
constexpr std::size_t kMostHypotheses = 10;

/// Two hypotheses are of one cluster up to this distance [cells] and this angle [rad].
constexpr double kClusterRadius = 3.5;
constexpr double kClusterAngle = 25.0 * kPi / 180.0;

/// The hypotheses that put the robot where the best one does, against those that do not.
struct HypothesisCluster {
  std::size_t chosen = 0;
  /// What the best scores above the best of those that contradict it, and above the mean of them;
  /// both at least 0, and 0 where none contradicts it.
  double margin = 0.0;
  double mean_margin = 0.0;
  /// What the best scores, at least 0, where none contradicts it; else 0.
  double unopposed = 0.0;
};

/// Neighbouring places see the same walls, so several may align rightly with one scan. Hypotheses,
/// best score first, that put the robot at the same spot as the best one do not contradict it, and
/// of their places the one is chosen that the robot stands nearest to (paper 7: a place is the
/// region about its location). The best kMostHypotheses count, and of them those of the best one's
/// session: where places of another session lie tells nothing here. `hypotheses` is not empty.
HypothesisCluster clusterHypotheses(const std::vector<PoseHypothesis>& hypotheses,
                                    double cell_size);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_HYPOTHESIS_CLUSTER_H
