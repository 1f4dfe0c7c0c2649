#ifndef PLACE_MEMORY_SIM_ROBOT_RANDOM_ROBOT_H
#define PLACE_MEMORY_SIM_ROBOT_RANDOM_ROBOT_H

#include <cstdint>

#include "sim/senses/simulated_scan.h"

namespace place_memory::sim {

/// A random robot, repeatable by its seed: a full ring of 8 to 24 sonars, a half ring of nine over
/// +-67.5 degrees or a few, or one sensor that spins through the full turn; cones of 15 to 40
/// degrees, ranges up to 2 to 6 m, range noise 0.5 to 3 %, 0 to 10 % of the echoes lost, and
/// sensors from mirror shy to ones that hear every surface.
SimulatedRobot randomRobot(std::uint64_t seed);

/// The kind that fits a building of small scale: one spinning sensor with a short range.
SimulatedRobot randomSpinningRobot(std::uint64_t seed);

}  // namespace place_memory::sim

#endif  // PLACE_MEMORY_SIM_ROBOT_RANDOM_ROBOT_H
