#ifndef PLACE_MEMORY_SIM_NODE_SIM_PARAMETERS_H
#define PLACE_MEMORY_SIM_NODE_SIM_PARAMETERS_H

#include <ros/node_handle.h>

#include "place_memory/core/pose2d.h"
#include "sim/robot/simulation.h"
#include "sim/world/world.h"
#include "sim_node/robot_driver.h"

namespace place_memory::sim_node {

/// What config/sim.yaml describes.
struct SimParameters {
  sim::World world;
  core::Pose2d start;         ///< in the frame world
  double sonar_period = 0.4;  ///< [s]
  double speed = 1.0;         ///< simulated time over real time
  sim::SimulationOptions options;
  DriverOptions driver;
};

/// Reads the private parameters. Throws config::ParameterError with all that is wrong with them,
/// and sim::WorldError where the world cannot be used.
SimParameters readSimParameters(const ros::NodeHandle& private_names, bool simulated_time);

}  // namespace place_memory::sim_node

#endif  // PLACE_MEMORY_SIM_NODE_SIM_PARAMETERS_H
