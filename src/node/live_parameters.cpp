#include "node/live_parameters.h"

#include <ros/console.h>
#include <yaml-cpp/yaml.h>

#include <exception>
#include <stdexcept>
#include <utility>

#include "config/load_parameters.h"
#include "config/search_methods.h"

namespace place_memory::node {
namespace {

MatchConfig matchConfig(const config::Parameters& parameters) {
  const core::RecognizerOptions& options = parameters.match.recognizer;
  MatchConfig config = MatchConfig::__getDefault__();
  config.method = config::wordFor(options.method);
  config.position_window = options.position_window;
  config.heading_window = options.heading_window;
  config.confidence = options.confidence;
  return config;
}

PlacesConfig placesConfig(const config::Parameters& parameters) {
  PlacesConfig config = PlacesConfig::__getDefault__();
  config.adapt = parameters.places.enabled;
  config.retention = parameters.places.retention;
  return config;
}

SonarConfig sonarConfig(const config::Parameters& parameters) {
  SonarConfig config = SonarConfig::__getDefault__();
  config.top_is_no_echo = parameters.no_echo.top;
  config.zero_is_no_echo = parameters.no_echo.zero;
  return config;
}

/// By the parser that reads them at a start. Throws config::ParameterError.
config::Parameters parse(const std::string& table, const YAML::Node& values) {
  YAML::Node all;
  all[table] = values;
  return config::parseParameters(all, "dynamic_reconfigure");
}

/// What clients see first is what holds, whatever the defaults of the .cfg file are.
template <class Config, class Handler>
void serve(dynamic_reconfigure::Server<Config>& server, const Config& at_start, Handler handler) {
  server.updateConfig(at_start);
  server.setCallback([handler](Config& wanted, std::uint32_t /*level*/) { handler(wanted); });
}

}  // namespace

LiveParameters::LiveParameters(const ros::NodeHandle& private_names,
                               const config::Parameters& at_start, Changed changed)
    : now_(at_start),
      changed_(std::move(changed)),
      match_(mutex_, ros::NodeHandle(private_names, "match")),
      places_(mutex_, ros::NodeHandle(private_names, "places")),
      sonar_(mutex_, ros::NodeHandle(private_names, "sonar")) {
  serve(match_, matchConfig(now_), [this](MatchConfig& wanted) { onMatch(wanted); });
  serve(places_, placesConfig(now_), [this](PlacesConfig& wanted) { onPlaces(wanted); });
  serve(sonar_, sonarConfig(now_), [this](SonarConfig& wanted) { onSonar(wanted); });
}

void LiveParameters::onMatch(MatchConfig& wanted) {
  const MatchConfig before = matchConfig(now_);
  config::Parameters parameters = now_;
  try {
    YAML::Node values;
    values["method"] = wanted.method;
    values["position_window"] = wanted.position_window;
    values["heading_window"] = wanted.heading_window;
    values["confidence"] = wanted.confidence;
    const core::RecognizerOptions parsed = parse("match", values).match.recognizer;
    core::RecognizerOptions& options = parameters.match.recognizer;
    options.method = parsed.method;
    options.position_window = parsed.position_window;
    options.heading_window = parsed.heading_window;
    options.confidence = parsed.confidence;
    if (now_.heading_topic.empty() &&
        options.heading_window != now_.match.recognizer.heading_window) {
      throw std::invalid_argument(
          "match/heading_window: must stay pi where heading_topic is empty: nothing says how far "
          "odometry's yaw is off");
    }
    changed_(parameters);
    now_ = parameters;
  } catch (const std::exception& error) {
    ROS_ERROR("match stays as it was: %s", error.what());
    wanted = before;
  }
}

void LiveParameters::onPlaces(PlacesConfig& wanted) {
  const PlacesConfig before = placesConfig(now_);
  config::Parameters parameters = now_;
  try {
    YAML::Node values;
    values["adapt"] = wanted.adapt;
    values["retention"] = wanted.retention;
    parameters.places = parse("places", values).places;
    changed_(parameters);
    now_ = parameters;
  } catch (const std::exception& error) {
    ROS_ERROR("places stay as they were: %s", error.what());
    wanted = before;
  }
}

void LiveParameters::onSonar(SonarConfig& wanted) {
  now_.no_echo.top = wanted.top_is_no_echo;
  now_.no_echo.zero = wanted.zero_is_no_echo;
  changed_(now_);
}

}  // namespace place_memory::node
