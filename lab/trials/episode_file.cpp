#include "trials/episode_file.h"

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace place_memory::trials {
namespace {

using nlohmann::json;

/// How far a compass that knows its way may be off (paper 4: errors of up to 45 degrees).
constexpr double kCompassWindow = core::kPi / 4.0;

std::vector<core::SonarReading> readingsOf(const json& line, double heading) {
  const core::SonarSpec spec{line.at("fov"), line.at("r_min"), line.at("r_max")};
  if (!(spec.field_of_view > 0.0 && spec.field_of_view <= core::kPi && spec.min_range >= 0.0 &&
        spec.max_range > spec.min_range)) {
    throw std::runtime_error("fov, r_min and r_max describe no sonar");
  }
  const double radius = line.at("ring_radius");
  std::vector<core::SonarReading> readings;
  for (const json& entry : line.at("readings")) {
    const double bearing = entry.at(1);
    const double turn = entry.at(2);
    const core::Pose2d base{0.0, 0.0, heading + turn};
    const core::Pose2d sensor{radius * std::cos(bearing), radius * std::sin(bearing), bearing};
    const double range =
        entry.at(3).is_null() ? std::numeric_limits<double>::infinity() : entry.at(3).get<double>();
    if (std::isfinite(range) && (range < spec.min_range || range > spec.max_range)) continue;
    readings.push_back({base * sensor, spec, range});
  }
  return readings;
}

void addLine(const json& line, TrialSet& set) {
  const auto pose = line.at("pose").get<std::vector<double>>();
  if (pose.size() != 3) throw std::runtime_error("pose must hold x, y and yaw");
  const double compass = line.at("compass");
  const core::Pose2d odom_from_scan{pose[0], pose[1], core::wrapAngle(-compass)};
  std::vector<core::SonarReading> readings = readingsOf(line, pose[2] + compass);
  const std::string role = line.at("role");
  set.cell_size = line.at("cell");
  if (role == "learn") {
    set.learned.push_back({line.at("place"), odom_from_scan, std::move(readings)});
  } else if (role == "recognize") {
    const double window = line.at("any_heading").get<bool>() ? core::kPi : kCompassWindow;
    set.trials.push_back({line.at("accept"), odom_from_scan, window, std::move(readings)});
  } else {
    throw std::runtime_error("role must be learn or recognize, not '" + role + "'");
  }
}

}  // namespace

TrialSet readEpisodeFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  boost::iostreams::filtering_istream input;
  const bool gzipped = path.size() > 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
  if (gzipped) input.push(boost::iostreams::gzip_decompressor());
  input.push(file);
  TrialSet set;
  set.name = path.substr(path.find_last_of('/') + 1);
  std::string text;
  int number = 0;
  try {
    while (std::getline(input, text)) {
      ++number;
      addLine(json::parse(text), set);
    }
    if (input.bad()) throw std::runtime_error("cannot be read any further");
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ":" + std::to_string(number) + ": " + error.what());
  }
  if (set.learned.empty() || set.trials.empty()) {
    throw std::runtime_error(path + ": needs at least one learn and one recognize line");
  }
  return set;
}

}  // namespace place_memory::trials
