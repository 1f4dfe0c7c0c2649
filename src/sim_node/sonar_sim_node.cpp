#include <ros/ros.h>

#include <cstdlib>
#include <exception>
#include <iostream>

#include "sim_node/sim_parameters.h"
#include "sim_node/sonar_sim.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "sonar_sim");
  try {
    const ros::NodeHandle names;
    const ros::NodeHandle private_names("~");
    bool simulated_time = false;
    ros::param::get("/use_sim_time", simulated_time);
    const auto parameters =
        place_memory::sim_node::readSimParameters(private_names, simulated_time);
    place_memory::sim_node::SonarSim(names, private_names, parameters, simulated_time).run();
  } catch (const std::exception& error) {
    std::cerr << "sonar_sim_node: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
