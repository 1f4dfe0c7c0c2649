#include <ros/callback_queue.h>
#include <ros/init.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "place_memory/node/parameter_server.h"
#include "place_memory/node/place_memory_node.h"

namespace {

volatile std::sig_atomic_t stop_requested = 0;

void requestStop(int /*signal*/) { stop_requested = 1; }

void run() {
  const ros::NodeHandle names;
  const ros::NodeHandle private_names("~");
  place_memory::node::PlaceMemoryNode node(
      names, private_names, place_memory::node::readPrivateParameters(private_names));
  const ros::WallDuration poll(0.1);
  while (ros::ok() && stop_requested == 0) ros::getGlobalCallbackQueue()->callAvailable(poll);
  node.stop();
}

}  // namespace

int main(int argc, char** argv) {
  // roscpp's own handler shuts down before the robot could be told to stop turning.
  ros::init(argc, argv, "place_memory", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, requestStop);
  std::signal(SIGTERM, requestStop);
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << "place_memory_node: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
