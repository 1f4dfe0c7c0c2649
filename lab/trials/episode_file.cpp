#include "trials/episode_file.h"

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

namespace place_memory::trials {
namespace {

using nlohmann::json;

/// How far a compass that knows its way may be off (paper 4: errors of up to 45 degrees).
constexpr double kCompassWindow = core::kPi / 4.0;

/// As of parameter grid/cell_size [m].
constexpr double kLeastCell = 0.001;
constexpr double kLargestCell = 100.0;

/// Nothing that a robot in a building has is larger: metres, or radians.
constexpr double kLargest = 1e6;

/// Throws where it is wrong, by the name of its field.
double number(const json& value, const std::string& field, double low = -kLargest,
              double high = kLargest) {
  if (value.is_number()) {
    const double given = value;
    if (given >= low && given <= high) return given;
  }
  std::ostringstream rule;
  rule << field << " must be a number in [" << low << ", " << high << "], not " << value.dump();
  throw std::runtime_error(rule.str());
}

double numberAt(const json& line, const std::string& field, double low = -kLargest,
                double high = kLargest) {
  return number(line.at(field), field, low, high);
}

std::vector<core::SonarReading> readingsOf(const json& line, double heading) {
  const core::SonarSpec spec{numberAt(line, "fov", 0.0, core::kPi), numberAt(line, "r_min", 0.0),
                             numberAt(line, "r_max", 0.0)};
  if (!(spec.field_of_view > 0.0 && spec.max_range > spec.min_range)) {
    throw std::runtime_error("fov, r_min and r_max describe no sonar");
  }
  const double radius = numberAt(line, "ring_radius", 0.0);
  const json& entries = line.at("readings");
  if (!entries.is_array() || entries.empty()) {
    throw std::runtime_error("readings must be a list of one reading or more");
  }
  std::vector<core::SonarReading> readings;
  for (const json& entry : entries) {
    if (!entry.is_array() || entry.size() != 4) {
      throw std::runtime_error("readings must each hold set, bearing, turn and range, not " +
                               entry.dump());
    }
    const double bearing = number(entry[1], "the bearing of a reading");
    const double turn = number(entry[2], "the turn of a reading");
    const core::Pose2d base{0.0, 0.0, heading + turn};
    const core::Pose2d sensor{radius * std::cos(bearing), radius * std::sin(bearing), bearing};
    const double range = entry[3].is_null() ? std::numeric_limits<double>::infinity()
                                            : number(entry[3], "the range of a reading");
    if (std::isfinite(range) && (range < spec.min_range || range > spec.max_range)) continue;
    readings.push_back({base * sensor, spec, range});
  }
  if (readings.empty()) throw std::runtime_error("readings must hold one within r_min and r_max");
  return readings;
}

core::Pose2d poseOf(const json& pose, const std::string& field) {
  if (!pose.is_array() || pose.size() != 3) {
    throw std::runtime_error(field + " must be x, y and yaw");
  }
  return {number(pose[0], field), number(pose[1], field), number(pose[2], field)};
}

std::vector<core::Pose2d> wayOf(const json& line) {
  std::vector<core::Pose2d> way;
  if (!line.contains("way")) return way;
  const json& poses = line.at("way");
  if (!poses.is_array() || poses.empty()) {
    throw std::runtime_error("way must be a list of one pose or more");
  }
  for (const json& pose : poses) way.push_back(poseOf(pose, "a pose of way"));
  return way;
}

void learnLine(const json& line, LearnedScan scan, TrialSet& set) {
  scan.label = line.at("place").get<std::string>();
  if (scan.label.empty()) throw std::runtime_error("place must not be empty");
  for (const LearnedScan& other : set.learned) {
    if (other.label == scan.label) {
      throw std::runtime_error("place: '" + scan.label + "' is learned for the second time");
    }
  }
  set.learned.push_back(std::move(scan));
}

void addLine(const json& line, TrialSet& set) {
  const core::Pose2d pose = poseOf(line.at("pose"), "pose");
  const double compass = numberAt(line, "compass");
  const core::Pose2d odom_from_scan{pose.x, pose.y, core::wrapAngle(-compass)};
  std::vector<core::SonarReading> readings = readingsOf(line, pose.yaw + compass);
  const std::string role = line.at("role");
  set.cell_size = numberAt(line, "cell", kLeastCell, kLargestCell);
  if (role == "learn") {
    learnLine(line, {{}, odom_from_scan, std::move(readings)}, set);
  } else if (role == "recognize") {
    const double window = line.at("any_heading").get<bool>() ? core::kPi : kCompassWindow;
    set.trials.push_back(
        {line.at("accept"), odom_from_scan, window, std::move(readings), 0, wayOf(line)});
  } else {
    throw std::runtime_error("role must be learn or recognize, not '" + role + "'");
  }
}

/// A place may be learned in a later line than that of a trial which names it.
void requireAccepted(const TrialSet& set, const std::vector<int>& lines, const std::string& path) {
  std::set<std::string> labels;
  for (const LearnedScan& scan : set.learned) labels.insert(scan.label);
  for (std::size_t i = 0; i < set.trials.size(); ++i) {
    for (const std::string& label : set.trials[i].accept) {
      if (labels.count(label) > 0) continue;
      throw std::runtime_error(path + ":" + std::to_string(lines[i]) +
                               ": accept: no line learns '" + label + "'");
    }
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
  std::vector<int> trial_lines;
  try {
    while (std::getline(input, text)) {
      ++number;
      addLine(json::parse(text), set);
      if (trial_lines.size() < set.trials.size()) trial_lines.push_back(number);
    }
    if (input.bad()) throw std::runtime_error("cannot be read any further");
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ":" + std::to_string(number) + ": " + error.what());
  }
  if (set.learned.empty() || set.trials.empty()) {
    throw std::runtime_error(path + ": needs at least one learn and one recognize line");
  }
  requireAccepted(set, trial_lines, path);
  return set;
}

}  // namespace place_memory::trials
