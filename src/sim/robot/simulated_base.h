#ifndef PLACE_MEMORY_SIM_ROBOT_SIMULATED_BASE_H
#define PLACE_MEMORY_SIM_ROBOT_SIMULATED_BASE_H

#include "place_memory/core/pose2d.h"
#include "sim/scene/scene.h"
#include "sim/world/random.h"

namespace place_memory::sim {

/// How dead reckoning goes wrong; the slips of a run stay what they are, as tyres do on a carpet.
struct OdometryDrift {
  double distance = 0.01;        ///< 1 sigma of the scale of distances, >= 0
  double turn = 0.01;            ///< 1 sigma of the scale of turns, >= 0
  double turn_per_metre = 0.01;  ///< 1 sigma of the turn that is not noticed [rad/m], >= 0
};

/// A differential drive base: it follows velocities, stops at obstacles and believes its wheels.
class SimulatedBase {
 public:
  /// Stands at `start` (world); odometry begins at the origin.
  SimulatedBase(const core::Pose2d& start, double radius, const OdometryDrift& drift, Rng& rng);

  /// Drives for `dt` seconds at `forward` [m/s] and `turn` [rad/s]. Returns false where something
  /// stood in the way: then it has only turned.
  bool step(double forward, double turn, double dt, const Scene& scene);

  /// Sets the base down elsewhere; odometry does not notice.
  void placeAt(const core::Pose2d& pose) { truth_ = pose; }

  const core::Pose2d& truth() const { return truth_; }
  const core::Pose2d& odometry() const { return odometry_; }

 private:
  core::Pose2d truth_;
  core::Pose2d odometry_;
  double radius_;
  double distance_scale_;
  double turn_scale_;
  double turn_per_metre_;
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_ROBOT_SIMULATED_BASE_H
