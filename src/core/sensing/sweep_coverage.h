#ifndef PLACE_MEMORY_CORE_SENSING_SWEEP_COVERAGE_H
#define PLACE_MEMORY_CORE_SENSING_SWEEP_COVERAGE_H

#include <map>
#include <optional>
#include <set>

#include "core/sensing/measurement.h"

namespace place_memory::core {

/// Which headings of a sweep have been sensed (paper 3.1.4: eleven sets of readings at intervals of
/// two degrees).
///
/// Headings are counted from that of the first reading, in both directions.
class SweepCoverage {
 public:
  /// `headings` >= 1; `step` between them [rad], in [0.001, pi]. `sensors` are waited for, as are
  /// all that are heard of during the sweep.
  SweepCoverage(int headings, double step, std::set<SensorId> sensors = {});

  /// A reading of a sensor was used, while the robot's base was at this yaw [rad].
  void add(SensorId sensor, double base_yaw);
  /// A reading of a sensor came that cannot be used: at the latest heading it has had its turn.
  void skip(SensorId sensor);

  int target() const { return headings_; }
  /// Headings at which a reading was used.
  int headings() const { return static_cast<int>(turns_at_.size()); }
  /// Headings that are over. The latest one is once every sensor has had its turn there; that no
  /// other is to come is known when one has had its second turn since the sweep began. A sensor
  /// that misses twenty turns of another one at a heading is not waited for any more.
  int completed() const;
  bool done() const { return completed() >= headings_; }
  /// In [0, 1].
  double fraction() const;

 private:
  void takeTurn(SensorId sensor);

  int headings_;
  double step_;
  int full_turn_ = 0;  // headings in a full turn where the sweep is one, otherwise 0
  std::map<int, std::map<SensorId, int>> turns_at_;  // of each sensor
  std::set<SensorId> sensors_;
  std::set<SensorId> heard_;
  bool sensors_known_ = false;
  std::optional<double> last_yaw_;
  double turned_ = 0.0;  // since the first reading [rad]
  int current_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_SWEEP_COVERAGE_H
