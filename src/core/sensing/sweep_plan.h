#ifndef PLACE_MEMORY_CORE_SENSING_SWEEP_PLAN_H
#define PLACE_MEMORY_CORE_SENSING_SWEEP_PLAN_H

#include <string>
#include <vector>

namespace place_memory::core {

/// Where a sensor of the robot looks.
struct SensorMount {
  double bearing = 0.0;        ///< of its axis, from the base's x axis [rad]
  double field_of_view = 0.0;  ///< full opening angle of its cone [rad], > 0
};

/// How far a robot turns for a scan of everything around it.
struct SweepPlan {
  int headings = 11;
  double step = 0.0;   ///< between them [rad]
  std::string reason;  ///< how far, and why, in a sentence for people

  bool isFullTurn() const;
};

/// Plans by the sensors there are: as many headings as the paper has (3.1.4) where their cones lie
/// close together; a wider gap between two cones is closed by turning further, until the inner half
/// of a cone has looked into all of it; where that takes more than half a turn, it is a full one.
/// The fewer sensors, the smaller the steps, so that at least 96 readings come of it. `step` [rad]
/// > 0 is kept; 0: planned too. At most 3600 headings.
SweepPlan planSweep(const std::vector<SensorMount>& sensors, double step = 0.0);

/// How long a robot takes at the most that obeys [s]. `max_rate` [rad/s], > 0.
double reckonedSeconds(const SweepPlan& plan, double max_rate);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_SENSING_SWEEP_PLAN_H
