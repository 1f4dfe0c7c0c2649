#include "sim/robot/random_robot.h"

namespace place_memory::sim {

namespace {

constexpr double kDegree = core::kPi / 180.0;

SonarPhysics randomPhysics(Rng& rng) {
  SonarPhysics physics;
  physics.edge_gain = uniform(rng, 0.15, 0.8);
  physics.reach = uniform(rng, 5.0, 14.0);
  physics.roughness = chance(rng, 0.25) ? uniform(rng, 3.0, 8.0) : uniform(rng, 0.7, 2.5);
  physics.threshold_noise = uniform(rng, 0.05, 0.4);
  physics.relative_noise = uniform(rng, 0.005, 0.03);
  physics.absolute_noise = uniform(rng, 0.001, 0.01);
  physics.range_scale = 1.0 + 0.01 * normal(rng);
  physics.drop_probability = uniform(rng) * uniform(rng) * 0.10;
  physics.cross_talk = uniform(rng) * 0.01;
  return physics;
}

core::SonarSpec randomSpec(Rng& rng, double longest) {
  return {uniform(rng, 15.0, 40.0) * kDegree, uniform(rng, 0.02, 0.2), uniform(rng, 2.0, longest)};
}

void useFullRing(SimulatedRobot& robot, Rng& rng) {
  const int counts[] = {8, 12, 16, 16, 24};
  robot.ring.count = counts[uniformIndex(rng, 5)];
  robot.ring.spacing = 2.0 * core::kPi / robot.ring.count;
  robot.ring.first_bearing = chance(rng, 0.5) ? 0.0 : 0.5 * robot.ring.spacing;
  robot.sweep.headings = uniformInt(rng, 3, 11);
  robot.sweep.step = robot.ring.spacing / robot.sweep.headings;
}

void usePartialRing(SimulatedRobot& robot, Rng& rng) {
  robot.ring.count = chance(rng, 0.6) ? 9 : uniformInt(rng, 1, 8);
  const double half = robot.ring.count == 9 ? 67.5 * kDegree : uniform(rng, 40.0, 90.0) * kDegree;
  robot.ring.spacing = robot.ring.count > 1 ? 2.0 * half / (robot.ring.count - 1) : core::kPi;
  robot.ring.first_bearing = robot.ring.count > 1 ? -half : 0.0;
  const bool turns_fully = robot.ring.count < 5 || chance(rng, 0.3);
  robot.sweep.headings = turns_fully ? uniformInt(rng, 60, 120) / robot.ring.count + 12 : 11;
  robot.sweep.step = turns_fully ? 2.0 * core::kPi / robot.sweep.headings : 2.0 * kDegree;
}

void useSpinningSensor(SimulatedRobot& robot, Rng& rng) {
  const int steps[] = {72, 90, 120, 180, 360};
  robot.ring.count = 1;
  robot.ring.first_bearing = 0.0;
  robot.sweep.headings = steps[uniformIndex(rng, 5)];
  robot.sweep.step = (chance(rng, 0.5) ? 2.0 : -2.0) * core::kPi / robot.sweep.headings;
  robot.sweep.set_period = 0.08;
  robot.ring.radius = uniform(rng, 0.0, 0.1);
}

}  // namespace

SimulatedRobot randomRobot(std::uint64_t seed) {
  Rng rng(seed);
  SimulatedRobot robot;
  robot.physics = randomPhysics(rng);
  robot.ring.radius = uniform(rng, 0.05, 0.25);
  const double kind = uniform(rng);
  if (kind < 0.55) {
    useFullRing(robot, rng);
  } else if (kind < 0.85) {
    usePartialRing(robot, rng);
  } else {
    useSpinningSensor(robot, rng);
  }
  robot.ring.spec = randomSpec(rng, 6.0);
  return robot;
}

SimulatedRobot randomSpinningRobot(std::uint64_t seed) {
  Rng rng(seed);
  SimulatedRobot robot;
  robot.physics = randomPhysics(rng);
  useSpinningSensor(robot, rng);
  robot.ring.spec = randomSpec(rng, 3.0);
  return robot;
}

}  // namespace place_memory::sim
