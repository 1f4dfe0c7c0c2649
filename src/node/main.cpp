#include <ros/console.h>
#include <ros/init.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "node/parameter_server.h"
#include "node/place_memory_node.h"

namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void onSignal(int /*signal*/) { stop_requested = true; }

/// As `rosnode kill` asks, or a newer node of this name.
void onShutdown(XmlRpc::XmlRpcValue& parameters, XmlRpc::XmlRpcValue& result) {
  if (parameters.getType() == XmlRpc::XmlRpcValue::TypeArray && parameters.size() > 1 &&
      parameters[1].getType() == XmlRpc::XmlRpcValue::TypeString) {
    ROS_WARN("asked to end: %s", static_cast<std::string>(parameters[1]).c_str());
  }
  stop_requested = true;
  result = ros::xmlrpc::responseInt(1, "", 0);
}

/// roscpp's own handlers shut down before the robot could be told to stop turning. These are set
/// only now: a constructor that waits, as for a master, ends with the signal.
void handleStops() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", onShutdown);
}

void run() {
  const ros::NodeHandle names;
  const ros::NodeHandle private_names("~");
  place_memory::node::PlaceMemoryNode node(
      names, private_names, place_memory::node::readPrivateParameters(private_names));
  handleStops();
  const ros::WallDuration poll(0.1);
  while (ros::ok() && !stop_requested) node.spinOnce(poll);
  node.stop();
}

}  // namespace

int main(int argc, char** argv) {
  // What is said is to be read at once, in a file or by another program too.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  ros::init(argc, argv, "place_memory", ros::init_options::NoSigintHandler);
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << "place_memory_node: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
