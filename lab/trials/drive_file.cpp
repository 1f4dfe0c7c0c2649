#include "trials/drive_file.h"

#include <algorithm>
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

constexpr double kLeastRange = 0.05;  // [m]

bool gzipped(const std::string& path) {
  return path.size() > 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
}

core::Pose2d poseOf(const json& entry) {
  const auto numbers = entry.get<std::vector<double>>();
  if (numbers.size() != 3) throw std::runtime_error("a pose must hold x, y and yaw");
  return {numbers[0], numbers[1], numbers[2]};
}

json asJson(const core::Pose2d& pose) { return json::array({pose.x, pose.y, pose.yaw}); }

DriveMoment momentOf(const json& line) {
  DriveMoment moment;
  moment.t = line.at("t");
  moment.odom = poseOf(line.at("odom"));
  if (!line.at("truth").is_null()) moment.truth = poseOf(line.at("truth"));
  if (line.contains("heading") && !line.at("heading").is_null()) moment.heading = line["heading"];
  const double fov = line.at("fov");
  for (const json& entry : line.at("readings")) {
    const double longest = entry.at(4);
    const core::SonarSpec spec{fov, std::min(kLeastRange, 0.5 * longest), longest};
    double range = std::numeric_limits<double>::infinity();
    if (!entry.at(3).is_null() && entry.at(3).get<double>() < longest) {
      range = std::max(entry.at(3).get<double>(), spec.min_range);
    }
    moment.readings.push_back({{entry.at(1), entry.at(2), entry.at(0)}, spec, range});
  }
  return moment;
}

}  // namespace

Drive readDriveFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  boost::iostreams::filtering_istream input;
  if (gzipped(path)) input.push(boost::iostreams::gzip_decompressor());
  input.push(file);
  Drive drive;
  std::string text;
  int number = 0;
  try {
    while (std::getline(input, text)) {
      ++number;
      drive.push_back(momentOf(json::parse(text)));
    }
    if (input.bad()) throw std::runtime_error("cannot be read any further");
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ":" + std::to_string(number) + ": " + error.what());
  }
  return drive;
}

void writeDriveFile(const Drive& drive, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  boost::iostreams::filtering_ostream output;
  if (gzipped(path)) output.push(boost::iostreams::gzip_compressor());
  output.push(file);
  for (const DriveMoment& moment : drive) {
    json line{{"t", moment.t}, {"odom", asJson(moment.odom)}, {"truth", nullptr}};
    if (moment.truth) line["truth"] = asJson(*moment.truth);
    if (moment.heading) line["heading"] = *moment.heading;
    line["fov"] = moment.readings.empty() ? 0.4 : moment.readings.front().spec.field_of_view;
    json& readings = line["readings"] = json::array();
    for (const core::SonarReading& reading : moment.readings) {
      json range = nullptr;
      if (std::isfinite(reading.range)) range = reading.range;
      const core::Pose2d& at = reading.sensor_pose;
      readings.push_back({at.yaw, at.x, at.y, range, reading.spec.max_range});
    }
    output << line.dump() << '\n';
  }
  output.reset();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace place_memory::trials
