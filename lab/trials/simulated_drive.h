#ifndef PLACE_MEMORY_TRIALS_SIMULATED_DRIVE_H
#define PLACE_MEMORY_TRIALS_SIMULATED_DRIVE_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/scene/crowd.h"
#include "sim/scene/scene.h"
#include "sim/senses/compass_field.h"
#include "sim/senses/simulated_scan.h"
#include "sim/world/random.h"
#include "sim/world/world.h"
#include "trials/drive_file.h"

namespace place_memory::trials {

/// How a simulated robot drives about, and what its wheels and its compass get wrong.
struct DriveRecipe {
  double way = 200.0;   ///< [m]
  double speed = 0.35;  ///< [m/s]
  double tick = 0.1;    ///< from moment to moment [s]
  int round = 4;        ///< moments in which every sonar fires once
  /// Of the ring; empty: all.
  std::vector<int> sonars;
  double compass_sigma = 10.0 * core::kPi / 180.0;  ///< bound to the place [rad]; < 0: no compass
  double compass_noise = 2.0 * core::kPi / 180.0;   ///< of each heading [rad]
  double scale_sigma = 0.02;                        ///< of distances, for the whole drive
  double turn_factor_sigma = 0.03;                  ///< of turns, likewise
  double bend_sigma = 1.0 * core::kPi / 180.0;      ///< likewise [rad/m]
  double yaw_noise = 1.5 * core::kPi / 180.0;       ///< [rad] by the root of the way [m]
  int people = 2;
  bool changes = true;  ///< half way doors, chairs and bicycles are elsewhere
  /// With `changes`: not half way, but each time so much way is done [m]; 0: half way.
  double change_every = 0.0;
  std::size_t start = 0;  ///< index of the place that it starts at
  /// Ways at which somebody carries it to another place, turned by any angle, rising [m].
  std::vector<double> carried;
};

/// Odometry that errs by a recipe.
class Wheels {
 public:
  Wheels(const DriveRecipe& recipe, sim::Rng& rng);

  void move(double forward, double turn, sim::Rng& rng);
  /// By a step as it was in truth; short beside the bends of the way.
  void move(const core::Pose2d& step, sim::Rng& rng);
  const core::Pose2d& pose() const { return pose_; }

 private:
  double believedTurn(double way, double turn, sim::Rng& rng) const;

  double noise_, scale_, turn_, bend_;
  core::Pose2d pose_;
};

/// A robot in a world that drives as it is told and senses by the recipe; repeatable by the seed
/// and the calls made. Of the recipe `way`, `changes`, `carried` and `speed` are not its matter.
class DriveSimulator {
 public:
  DriveSimulator(const sim::World& world, const sim::SimulatedRobot& robot,
                 const DriveRecipe& recipe, std::uint64_t seed);

  struct Step {
    bool is_blocked = false;  ///< something stood in the way: it has not moved
    double forward = 0.0;     ///< that it has moved [m]
    DriveMoment moment;       ///< what it sensed then
  };
  /// Goes on by one tick: turns by `turn` [rad] and drives `forward` [m].
  Step step(double forward, double turn);

  const core::Pose2d& base() const { return base_; }
  void putAt(const core::Pose2d& base) { base_ = base; }
  void setWorld(const sim::World& world) { scene_ = std::make_unique<sim::Scene>(world); }
  const sim::Scene& scene() const { return *scene_; }
  sim::Rng& rng() { return rng_; }

  static constexpr double kBaseRadius = 0.22;  ///< [m]

 private:
  const sim::SimulatedRobot robot_;
  const DriveRecipe recipe_;
  sim::Rng rng_;
  std::unique_ptr<sim::Scene> scene_;
  sim::Crowd crowd_;
  sim::CompassField compass_;
  Wheels wheels_;
  core::Pose2d base_;
  std::vector<int> sonars_;
  std::size_t next_ = 0;
  double t_ = 0.0;
};

/// The same drive by wheels and a compass that err by the recipe, repeatable by the seed. The drive
/// knows its truth; of the recipe only the errors matter.
Drive withErrors(const Drive& drive, const DriveRecipe& recipe, std::uint64_t seed);

/// A drive from place to place along the world's links, repeatable by its seed.
Drive simulateDrive(const sim::World& world, const sim::SimulatedRobot& robot,
                    const DriveRecipe& recipe, std::uint64_t seed);

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_SIMULATED_DRIVE_H
