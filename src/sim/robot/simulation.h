#ifndef PLACE_MEMORY_SIM_ROBOT_SIMULATION_H
#define PLACE_MEMORY_SIM_ROBOT_SIMULATION_H

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/robot/simulated_base.h"
#include "sim/scene/crowd.h"
#include "sim/scene/scene.h"
#include "sim/senses/compass_field.h"
#include "sim/senses/laser_model.h"
#include "sim/senses/simulated_scan.h"
#include "sim/world/random.h"
#include "sim/world/world.h"

namespace place_memory::sim {

struct SimulationOptions {
  std::uint64_t seed = 1;
  int people = 0;              ///< walking about, >= 0
  double compass_sigma = 0.0;  ///< place-bound compass error [rad], >= 0
  double base_radius = 0.25;   ///< [m]
  OdometryDrift drift;
  SimulatedRobot robot;
};

enum class ChangeResult {
  kDone,
  kUnknownName,  ///< the world has nothing of that name
  kBlocked,      ///< it would have come to lie on the robot, or at no finite position
};

/// A robot, people and a world that go on in time; repeatable by the seed and the calls made.
class Simulation {
 public:
  Simulation(World world, const core::Pose2d& start, const SimulationOptions& options);

  /// Goes on by `dt` seconds, the base driving at `forward` [m/s] and `turn` [rad/s].
  void step(double dt, double forward, double turn);

  /// One firing of the ring from where the base stands; infinities by REP 117.
  std::vector<double> fire();

  /// One turn of a laser at the base's middle: the range of each ray counter-clockwise from
  /// straight ahead [m]; infinities by REP 117.
  std::vector<double> sweepLaser(const LaserModel& laser);

  /// The heading that the compass shows: yaw from its east [rad], in [-pi, pi).
  double compassHeading() const;

  /// Puts the base down elsewhere. False where it would stand on something.
  bool placeRobot(const core::Pose2d& pose);

  /// By name. Only kDone changes anything.
  ChangeResult setDoor(const std::string& name, bool open);
  ChangeResult moveChair(const std::string& name, const core::Pose2d& pose);
  ChangeResult removeWhiteboard(const std::string& name);

  /// What a working day does: moves a share of the chairs by up to a metre and flips a share of the
  /// doors, both in [0, 1], and brings so many bicycles. The robot keeps its room. Returns how many
  /// things changed.
  int rearrange(double chairs, double doors, int bicycles);

  const World& world() const { return world_; }
  const Scene& scene() const { return *scene_; }
  const std::vector<Circle>& people() const { return crowd_.circles(); }
  const SimulatedBase& base() const { return base_; }
  const SimulatedRobot& robot() const { return options_.robot; }

 private:
  bool leavesRoom(const Scene& scene) const;
  ChangeResult adopt(World changed);

  SimulationOptions options_;
  World world_;
  Rng rng_;
  std::unique_ptr<Scene> scene_;
  Crowd crowd_;
  SimulatedBase base_;
  CompassField compass_;
};

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_ROBOT_SIMULATION_H
