#include "sim_node/sim_parameters.h"

#include <string>
#include <vector>

#include "config/parameter_reader.h"
#include "node/parameter_server.h"
#include "place_memory/config/parameter_error.h"
#include "sim/scene/world_loader.h"

namespace place_memory::sim_node {
namespace {

constexpr double kFarthest = 1e6;  // [m]

std::string checkPath(const std::string& path) { return path.empty() ? "must not be empty" : ""; }

YAML::Node readTable(const ros::NodeHandle& private_names) {
  XmlRpc::XmlRpcValue values;
  if (!private_names.getParam(private_names.getNamespace(), values)) return {};
  return node::toYaml(values);
}

void readOptions(config::ParameterReader& reader, sim::SimulationOptions& options) {
  int seed = 1;
  reader.integer("seed", {0, 2147483647}, seed);
  options.seed = static_cast<std::uint64_t>(seed);
  reader.integer("people", {0, 100}, options.people);
  reader.number("compass_error", {0.0, core::kPi}, options.compass_sigma);
  reader.number("odometry/distance", {0.0, 0.5}, options.drift.distance);
  reader.number("odometry/turn", {0.0, 0.5}, options.drift.turn);
  reader.number("odometry/turn_per_metre", {0.0, 1.0}, options.drift.turn_per_metre);
}

}  // namespace

SimParameters readSimParameters(const ros::NodeHandle& private_names, bool simulated_time) {
  config::ParameterReader reader;
  reader.add(readTable(private_names), private_names.getNamespace());

  SimParameters parameters;
  std::string path;
  reader.text("world", checkPath, path);
  if (!path.empty()) parameters.world = sim::loadWorld(path);
  if (!parameters.world.places.empty()) {
    const sim::Vec2 first = parameters.world.places.front().position;
    parameters.start = {first.x, first.y, 0.0};
  }
  reader.number("start/x", {-kFarthest, kFarthest}, parameters.start.x);
  reader.number("start/y", {-kFarthest, kFarthest}, parameters.start.y);
  reader.number("start/yaw", {-core::kPi, core::kPi}, parameters.start.yaw);
  reader.number("sonar_period", {0.05, 10.0}, parameters.sonar_period);
  reader.number("speed", {0.01, 100.0}, parameters.speed);
  readOptions(reader, parameters.options);

  std::vector<std::string> problems = reader.problems();
  if (problems.empty() && path.empty()) problems.push_back("world: the path of a world is needed");
  if (parameters.speed != 1.0 && !simulated_time) {
    problems.push_back("speed: only simulated time can go at another speed: set /use_sim_time");
  }
  if (!problems.empty()) throw config::ParameterError(problems);
  return parameters;
}

}  // namespace place_memory::sim_node
