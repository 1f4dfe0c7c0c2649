#ifndef PLACE_MEMORY_CORE_MAPPING_LOST_ESTIMATE_H
#define PLACE_MEMORY_CORE_MAPPING_LOST_ESTIMATE_H

namespace place_memory::core {

/// What one scan showed of whether the robot is where it thinks.
enum class ScanWitness {
  kAgrees,    ///< it was tracked at a place
  kSilent,    ///< no place is near where it thinks it is
  kMisses,    ///< a place is near, but the scan is not of it
  kDoubts,    ///< no place is near, and one is recognized where odometry cannot have brought it
  kElsewhere  ///< likewise, though a place is near that the scan should be of
};

/// P(lost): a two-state filter. A robot may be lifted at any time; scans at known places tell.
class LostEstimate {
 public:
  double probability() const { return lost_; }
  void set(double probability) { lost_ = probability; }

  /// `way`: since the last scan [m].
  void update(ScanWitness witness, double way);

 private:
  double lost_ = 0.0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_LOST_ESTIMATE_H
