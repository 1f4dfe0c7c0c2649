#ifndef PLACE_MEMORY_CORE_MAPPING_LOST_ESTIMATE_H
#define PLACE_MEMORY_CORE_MAPPING_LOST_ESTIMATE_H

#include <array>
#include <cstddef>

#include "core/mapping/continuity_watch.h"

namespace place_memory::core {

/// What one scan showed of whether the robot is where it thinks.
enum class ScanWitness {
  kAgrees,       ///< it was tracked at a place
  kSilent,       ///< no place is near where it thinks it is
  kMisses,       ///< a place is near, but the scan is not of it
  kContradicts,  ///< its newest readings are not of what should be there
  kDoubts,       ///< no place is near, and one is recognized where odometry cannot have brought it
  kElsewhere     ///< likewise, though a place is near that the scan should be of
};

constexpr std::size_t kScanWitnesses = 6;

/// How often robots are carried, by how much more often a lost robot's scans are of each kind than
/// another's, and by how much more often readings go on, and the compass turns, in each way where a
/// robot is carried than elsewhere. Neighbouring scans share readings, so these ratios are
/// softened.
struct LostModel {
  double lifted_per_metre;                     ///< of way, > 0
  std::array<double, kScanWitnesses> ratios;   ///< in the order of ScanWitness, > 0
  std::array<double, kContinuities> readings;  ///< in the order of Continuity, > 0
  std::array<double, kCompassTurns> compass;   ///< in the order of CompassTurn, > 0
};

/// P(lost): a two-state filter. A robot may be lifted at any time, most likely where what it senses
/// does not go on; scans at known places tell.
class LostEstimate {
 public:
  /// With a model that `place_memory_mapping fit_lost` counts.
  LostEstimate();
  explicit LostEstimate(const LostModel& model) : model_(model) {}

  double probability() const { return lost_; }
  void set(double probability) { lost_ = probability; }

  /// It drove, or was carried: the probability of that. `way`: since the last scan [m].
  double drive(const Spot& spot, double way);
  /// A scan showed something.
  void see(ScanWitness witness);

 private:
  LostModel model_;
  double lost_ = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_LOST_ESTIMATE_H
