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
constexpr std::size_t kMostSensors = 64;

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

std::string checkName(const std::string& name) {
  return name.empty() ? "must not be empty" : std::string();
}

void readDriver(config::ParameterReader& reader, DriverOptions& driver) {
  reader.choice("robot/message",
                {{"range", DriverOptions::Message::kRange},
                 {"point_cloud", DriverOptions::Message::kPointCloud},
                 {"point_cloud2", DriverOptions::Message::kPointCloud2},
                 {"laser_scan", DriverOptions::Message::kLaserScan}},
                driver.message);
  reader.choice("robot/no_echo",
                {{"infinity", DriverOptions::NoEcho::kInfinity},
                 {"max_range", DriverOptions::NoEcho::kMaxRange},
                 {"zero", DriverOptions::NoEcho::kZero}},
                driver.no_echo);
  reader.choice("robot/compass",
                {{"imu", DriverOptions::Compass::kImu},
                 {"bearing", DriverOptions::Compass::kBearing},
                 {"none", DriverOptions::Compass::kNone}},
                driver.compass);
  reader.texts("robot/topics", checkName, driver.topics);
  reader.texts("robot/frames", checkName, driver.frames);
  reader.text("robot/heading_topic", checkName, driver.heading_topic);
  reader.text("robot/odom_topic", checkName, driver.odom_topic);
  reader.text("robot/command_topic", checkName, driver.command_topic);
  reader.flag("robot/sensor_transforms", driver.sensor_transforms);
  reader.flag("robot/odom_transform", driver.odom_transform);
}

void readSensors(config::ParameterReader& reader, SimParameters& parameters) {
  sim::SimulatedRobot& robot = parameters.options.robot;
  reader.poses("robot/mounts", kMostSensors, robot.ring.mounts);
  if (!robot.ring.mounts.empty()) robot.ring.count = static_cast<int>(robot.ring.mounts.size());
  core::SonarSpec& spec = robot.ring.spec;
  reader.number("robot/field_of_view", {0.01, core::kPi, true, true}, spec.field_of_view);
  reader.number("robot/min_range", {0.0, 10.0, true, true}, spec.min_range);
  reader.number("robot/max_range", {0.1, 100.0, true, true}, spec.max_range);
  reader.number("robot/roughness", {0.1, 100.0, true, true}, robot.physics.roughness);
  reader.number("robot/base_radius", {0.02, 1.0, true, true}, parameters.options.base_radius);
  sim::LaserModel& laser = parameters.driver.laser;
  reader.integer("robot/rays", {1.0, 4000.0, true, true}, laser.rays);
  laser.min_range = spec.min_range;
  laser.max_range = spec.max_range;
}

// What no parameter can say alone.
void checkDriver(const SimParameters& parameters, std::vector<std::string>& problems) {
  const DriverOptions& driver = parameters.driver;
  const bool is_range = driver.message == DriverOptions::Message::kRange;
  const auto sensors = static_cast<std::size_t>(parameters.options.robot.ring.count);
  if (driver.topics.size() != 1 && !(is_range && driver.topics.size() == sensors)) {
    problems.push_back(is_range ? "robot/topics: must be one, or one for each sensor"
                                : "robot/topics: all points go to one topic");
  }
  if (!driver.frames.empty() && driver.frames.size() != (is_range ? sensors : 1)) {
    problems.push_back(is_range ? "robot/frames: must be one for each sensor"
                                : "robot/frames: must be one, of all points");
  }
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
  readDriver(reader, parameters.driver);
  readSensors(reader, parameters);

  std::vector<std::string> problems = reader.problems();
  if (problems.empty()) checkDriver(parameters, problems);
  if (problems.empty() && path.empty()) problems.push_back("world: the path of a world is needed");
  if (parameters.speed != 1.0 && !simulated_time) {
    problems.push_back("speed: only simulated time can go at another speed: set /use_sim_time");
  }
  if (!problems.empty()) throw config::ParameterError(problems);
  return parameters;
}

}  // namespace place_memory::sim_node
