#include "config/load_parameters.h"

#include <filesystem>
#include <set>
#include <sstream>

#include "config/parameter_reader.h"
#include "config/renamed_parameters.h"
#include "config/search_methods.h"
#include "config/store_path.h"
#include "config/yaml_file.h"
#include "place_memory/config/match_preset.h"
#include "support/text.h"

namespace place_memory::config {
namespace {

constexpr double kLongest = 3600.0;  // [s]
constexpr std::size_t kMostMounts = 64;
constexpr double kDay = 86400.0;  // [s]

Interval closed(double low, double high) { return {low, high, true, true}; }
Interval open(double low, double high) { return {low, high, false, false}; }
Interval leftOpen(double low, double high) { return {low, high, false, true}; }

std::string anything(const std::string& /*text*/) { return {}; }

// Of a frame; a leading slash, which tf2 does not know, is taken off later.
std::string checkFrame(const std::string& slashed) {
  const std::string name = support::withoutLeadingSlashes(slashed);
  if (name.empty()) return "must not be empty";
  if (support::hasControls(name)) return "must not hold line breaks or other control characters";
  if (support::trimmed(name) != name) return "must not begin or end with a blank";
  return {};
}

std::string checkOptionalFrame(const std::string& name) {
  return name.empty() ? std::string() : checkFrame(name);
}

void readFrame(ParameterReader& reader, const std::string& name, bool optional,
               std::string& frame) {
  reader.text(name, optional ? checkOptionalFrame : checkFrame, frame);
  frame = support::withoutLeadingSlashes(frame);
}

// Of a graph resource name (http://wiki.ros.org/Names).
std::string checkTopic(const std::string& name) {
  if (name.empty()) return "must not be empty";
  const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  if ((letters + "/").find(name.front()) == std::string::npos) {
    return "must begin with a letter or a slash";
  }
  if (name.find_first_not_of(letters + "0123456789_/", 1) != std::string::npos) {
    return "must consist of letters, digits, underscores and slashes";
  }
  return {};
}

std::string checkOptionalTopic(const std::string& name) {
  return name.empty() ? std::string() : checkTopic(name);
}

void readScan(ParameterReader& reader, ScanOptions& scan) {
  reader.integer("scan/headings", closed(0, 3600), scan.headings);
  reader.number("scan/step", closed(kLeastStep, core::kPi), scan.step);
  reader.choice("scan/turn", {{"listen", Turn::kListen}, {"cmd_vel", Turn::kCmdVel}}, scan.turn);
  reader.number("scan/turn_rate", leftOpen(0.0, core::kPi), scan.turn_rate);
  reader.number("scan/least_turn_rate", closed(0.0, core::kPi), scan.least_turn_rate);
  reader.number("scan/timeout", leftOpen(0.0, kLongest), scan.timeout);
  reader.integer("scan/min_readings", closed(1, 100000), scan.min_readings);
  reader.number("scan/tf_timeout", closed(0.0, 10.0), scan.tf_timeout);
  reader.number("scan/heading_timeout", leftOpen(0.0, kLongest), scan.heading_timeout);
  reader.number("scan/max_age", leftOpen(0.0, kDay), scan.max_age);
  reader.flag("scan/over_range_is_no_echo", scan.over_range_is_no_echo);
  reader.flag("scan/zero_range_is_no_echo", scan.zero_range_is_no_echo);
}

void readSonar(ParameterReader& reader, core::SonarModelOptions& sonar) {
  reader.number("sonar/prior", open(0.0, 1.0), sonar.prior);
  reader.number("sonar/occupied", open(0.0, 1.0), sonar.occupied);
  reader.number("sonar/empty", open(0.0, 1.0), sonar.empty);
  reader.number("sonar/echo_depth", closed(0.5, 8.0), sonar.echo_depth);
}

void readInputs(ParameterReader& reader, Parameters& parameters) {
  reader.flag("sonar/top_is_no_echo", parameters.no_echo.top);
  reader.flag("sonar/zero_is_no_echo", parameters.no_echo.zero);
  reader.number("heading/yaw_offset", closed(-core::kPi, core::kPi), parameters.heading.yaw_offset);
  reader.flag("heading/reversed", parameters.heading.reversed);
  reader.number("heading/declination", closed(-core::kPi, core::kPi),
                parameters.heading.declination);
  reader.number("cloud/max_range", leftOpen(0.0, 100.0), parameters.cloud.max_range);
  reader.number("cloud/field_of_view", leftOpen(0.0, core::kPi), parameters.cloud.field_of_view);
  reader.poses("cloud/mounts", kMostMounts, parameters.cloud.mounts);
  reader.integer("laser/cones", closed(1, 200), parameters.laser.cones);
}

void readMatch(ParameterReader& reader, MatchOptions& match) {
  reader.text("match/preset", anything, match.preset);
  reader.choice("match/method", searchMethods(), match.recognizer.method);
  reader.number("match/position_window", leftOpen(0.0, 100.0), match.recognizer.position_window);
  reader.number("match/heading_window", closed(0.0, core::kPi), match.recognizer.heading_window);
  reader.number("match/confidence", open(0.5, 1.0), match.recognizer.confidence);
  int threads = 0;
  reader.integer("match/threads", closed(0, static_cast<double>(core::kMostThreads)), threads);
  match.recognizer.threads = static_cast<std::size_t>(threads);
}

void readPlaces(ParameterReader& reader, core::AdaptationOptions& places) {
  reader.flag("places/adapt", places.enabled);
  reader.number("places/retention", {0.0, 1.0, true, false}, places.retention);
}

void readMap(ParameterReader& reader, MapOptions& map) {
  reader.number("map/resolution", closed(0.01, 1.0), map.resolution);
  reader.integer("map/max_cells", closed(4e6, 4e8), map.max_cells);
  reader.number("map/occupied", open(0.0, 1.0), map.occupied);
  reader.number("map/empty", open(0.0, 1.0), map.empty);
  reader.number("map/pause", closed(0.1, kLongest), map.pause);
}

void readRoutes(ParameterReader& reader, core::LinkLearningOptions& routes) {
  reader.number("routes/half_life", closed(1.0, 1000.0 * kDay), routes.half_life);
  reader.number("routes/speed", closed(0.01, 10.0), routes.speed);
}

void readDrive(ParameterReader& reader, DriveOptions& drive) {
  reader.choice("drive/correct",
                {{"always", Correct::kAlways},
                 {"when_lost", Correct::kWhenLost},
                 {"on_request", Correct::kOnRequest}},
                drive.correct);
  reader.number("drive/largest_jump", leftOpen(0.0, 100.0), drive.largest_jump);
  reader.flag("drive/initialpose", drive.initialpose);
  reader.choice("drive/by", {{"cmd_vel", DriveBy::kCmdVel}, {"move_base", DriveBy::kMoveBase}},
                drive.by);
  reader.number("drive/speed", leftOpen(0.0, 3.0), drive.speed);
  reader.number("drive/turn_rate", leftOpen(0.0, core::kPi), drive.turn_rate);
  reader.number("drive/radius", leftOpen(0.0, 5.0), drive.radius);
  reader.number("drive/clearance", leftOpen(0.0, 5.0), drive.clearance);
  reader.number("drive/patience", closed(0.0, kLongest), drive.patience);
  reader.number("drive/timeout", leftOpen(0.0, kLongest), drive.timeout);
}

Parameters readAll(ParameterReader& reader) {
  Parameters parameters;
  readFrame(reader, "odom_frame", true, parameters.odom_frame);
  readFrame(reader, "base_frame", false, parameters.base_frame);
  readFrame(reader, "map_frame", false, parameters.map_frame);
  reader.choice("mode", {{"off", Mode::kOff}, {"map", Mode::kMap}, {"localize", Mode::kLocalize}},
                parameters.mode);
  reader.flag("tf_broadcast", parameters.tf_broadcast);
  reader.number("tf_rate", leftOpen(0.0, 1000.0), parameters.tf_rate);
  reader.number("transform_tolerance", closed(0.0, 10.0), parameters.transform_tolerance);
  reader.texts("sonar_topics", checkTopic, parameters.sonar_topics);
  reader.text("heading_topic", checkOptionalTopic, parameters.heading_topic);
  reader.text("odom_topic", checkOptionalTopic, parameters.odom_topic);
  reader.text("store", checkStorePath, parameters.store);
  parameters.store = absoluteStorePath(parameters.store);
  reader.text("store_directory", checkStorePath, parameters.store_directory);
  parameters.store_directory = absoluteStorePath(parameters.store_directory);
  if (parameters.store_directory.empty() && !parameters.store.empty()) {
    parameters.store_directory = std::filesystem::path(parameters.store).parent_path().string();
  }
  reader.number("time_jump_tolerance", closed(0.0, 60.0), parameters.time_jump_tolerance);
  reader.number("grid/cell_size", closed(0.001, 100.0), parameters.grid.cell_size);
  readSonar(reader, parameters.sonar);
  readInputs(reader, parameters);
  readScan(reader, parameters.scan);
  readMatch(reader, parameters.match);
  readPlaces(reader, parameters.places);
  readMap(reader, parameters.map);
  readRoutes(reader, parameters.routes);
  readDrive(reader, parameters.drive);
  reader.integer("markers/labels", closed(0, 10000), parameters.markers.labels);
  reader.integer("markers/clickable", closed(0, 200), parameters.markers.clickable);
  return parameters;
}

// What no parameter can say alone.
void checkTogether(const Parameters& parameters, std::vector<std::string>& problems) {
  const core::SonarModelOptions& sonar = parameters.sonar;
  if (sonar.prior >= sonar.occupied || sonar.empty >= sonar.prior) {
    std::ostringstream text;
    text << "sonar: must be ascending: empty (" << sonar.empty << "), prior (" << sonar.prior
         << "), occupied (" << sonar.occupied << ")";
    problems.push_back(text.str());
  }
  if (parameters.map.empty >= parameters.map.occupied) {
    problems.push_back("map/empty: must be below map/occupied");
  }
  const std::set<std::string> topics(parameters.sonar_topics.begin(),
                                     parameters.sonar_topics.end());
  if (topics.size() < parameters.sonar_topics.size()) {
    problems.push_back("sonar_topics: a topic is given twice");
  }
  if (parameters.scan.least_turn_rate > parameters.scan.turn_rate) {
    problems.push_back("scan/least_turn_rate: must not exceed scan/turn_rate");
  }
  if (parameters.odom_frame == parameters.base_frame) {
    problems.push_back("odom_frame, base_frame: must not be the same frame");
  }
  if (parameters.odom_frame.empty() && parameters.heading_topic.empty()) {
    problems.push_back(
        "odom_frame, heading_topic: must not both be empty: a scan is laid along the compass or by "
        "odometry");
  }
  if (parameters.odom_frame.empty() && !parameters.odom_topic.empty()) {
    problems.push_back("odom_topic: needs an odom_frame, in which it says where the robot is");
  }
  std::set<std::string> others = topics;
  for (const std::string& topic : {parameters.heading_topic, parameters.odom_topic}) {
    if (!topic.empty() && !others.insert(topic).second) {
      problems.push_back("sonar_topics, heading_topic, odom_topic: " + topic + " is given twice");
    }
  }
  if (parameters.mode != Mode::kOff && parameters.odom_frame.empty()) {
    problems.push_back("mode: without an odom_frame nothing says how the robot drives");
  }
  if (parameters.tf_broadcast && parameters.odom_frame.empty()) {
    problems.push_back("tf_broadcast: without an odom_frame there is no transform to broadcast");
  }
  if (parameters.tf_broadcast && parameters.map_frame == parameters.odom_frame) {
    problems.push_back("tf_broadcast: map_frame, odom_frame: must not be the same frame");
  }
}

Parameters finish(ParameterReader& reader) {
  reader.renamed(renamedParameters());
  Parameters parameters = readAll(reader);
  // Nothing says how far odometry's yaw is off.
  if (parameters.heading_topic.empty()) parameters.match.recognizer.heading_window = core::kPi;
  std::vector<std::string> problems = reader.problems();
  if (problems.empty()) checkTogether(parameters, problems);
  try {
    const MatchPreset preset = loadPreset(parameters.match.preset);
    parameters.match.recognizer.metric = preset.metric;
    parameters.match.recognizer.rescoring = preset.rescoring;
    parameters.match.recognizer.calibration = preset.calibration;
    parameters.match.recognizer.located = !parameters.odom_frame.empty();
  } catch (const ParameterError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
  if (!problems.empty()) throw ParameterError(problems);
  return parameters;
}

}  // namespace

Parameters parseParameters(const YAML::Node& table, const std::string& source) {
  ParameterReader reader;
  reader.add(table, source);
  return finish(reader);
}

Parameters loadParameters(const std::vector<std::string>& paths) {
  ParameterReader reader;
  std::vector<std::string> unreadable;
  for (const std::string& path : paths) {
    try {
      reader.add(loadYamlFile(path), path);
    } catch (const ParameterError& error) {
      unreadable.insert(unreadable.end(), error.problems().begin(), error.problems().end());
    }
  }
  if (!unreadable.empty()) throw ParameterError(unreadable);
  return finish(reader);
}

std::set<std::string> parameterNames() {
  ParameterReader reader;
  readAll(reader);
  return reader.known();
}

}  // namespace place_memory::config
