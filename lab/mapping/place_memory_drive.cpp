// Replays a drive through the mapper and writes tables of what it made of it.

#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/load_parameters.h"
#include "core/mapping/final_way.h"
#include "core/mapping/mapper.h"
#include "trials/drive_file.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

constexpr double kStart = 1000.0;  // stamp of the first moment [s]

std::chrono::nanoseconds stampOf(double t) {
  return std::chrono::nanoseconds(std::llround(t * 1e9));
}

double seconds(std::chrono::nanoseconds stamp) { return static_cast<double>(stamp.count()) * 1e-9; }

std::string rowOf(double t, const core::Pose2d& pose) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3f,%.4f,%.4f,%.5f", t, pose.x, pose.y, pose.yaw);
  return text;
}

void writeAnswers(std::ofstream& table, const std::vector<core::ScanDecision>& decisions) {
  for (const core::ScanDecision& decision : decisions) {
    table << rowOf(seconds(decision.stamp), {})
                 .substr(0, rowOf(seconds(decision.stamp), {}).find(','))
          << ',' << core::nameOf(decision.kind) << ',';
    if (decision.place != core::kNoPlace) {
      const core::Pose2d& pose = decision.place_from_base;
      char text[96];
      std::snprintf(text, sizeof text, "%lld,%.4f,%.4f,%.5f",
                    static_cast<long long>(decision.place), pose.x, pose.y, pose.yaw);
      table << text;
    } else {
      table << ",,,";
    }
    table << ',' << decision.belief << ',' << decision.lost << ',' << decision.reason << '\n';
  }
}

/// Puts the robot down anywhere on the last drive, again and again, and prints how far it drives
/// until it names a place, and whether that is right.
void localizeFromAnywhere(core::Mapper& mapper, const trials::Drive& drive,
                          const std::map<core::PlaceId, core::Pose2d>& truth_of, int starts,
                          bool compass, double start) {
  mapper.setMode(core::MapperMode::kLocalize);
  std::vector<double> ways;
  int wrong = 0, never = 0;
  for (int k = 0; k < starts; ++k) {
    mapper.beginSession();
    start += 10000.0;
    const std::size_t first =
        drive.size() * static_cast<std::size_t>(k) * 9 / 10 / static_cast<std::size_t>(starts);
    double way = 0.0;
    bool named = false;
    for (std::size_t i = first; i < drive.size() && way < 10.0 && !named; ++i) {
      const trials::DriveMoment& moment = drive[i];
      const auto stamp = stampOf(start + moment.t);
      if (i > first) {
        way += std::hypot(moment.odom.x - drive[i - 1].odom.x, moment.odom.y - drive[i - 1].odom.y);
      }
      if (moment.heading && compass) mapper.addHeading(stamp, *moment.heading);
      mapper.addOdometry(stamp, moment.odom);
      for (const core::SonarReading& reading : moment.readings) {
        mapper.addReading(stamp, moment.odom, reading);
      }
      for (const core::ScanDecision& decision : mapper.takeDecisions()) {
        const auto place = truth_of.find(decision.place);
        if (decision.place == core::kNoPlace || place == truth_of.end()) continue;
        std::size_t at = i;
        while (at > 0 && start + drive[at].t > seconds(decision.stamp)) --at;
        const core::Pose2d true_pose = place->second.inverse() * *drive[at].truth;
        const double error = std::hypot(true_pose.x - decision.place_from_base.x,
                                        true_pose.y - decision.place_from_base.y);
        const double turn = core::wrapAngle(true_pose.yaw - decision.place_from_base.yaw);
        if (error > 0.75 || std::abs(turn) > 20.0 * core::kPi / 180.0) {
          ++wrong;
          std::printf("  wrong: start %d, %.2f m, %.1f degrees after %.2f m\n", k, error,
                      turn * 180.0 / core::kPi, way);
        }
        named = true;
        break;
      }
    }
    if (named) ways.push_back(way);
    if (!named) ++never;
  }
  std::sort(ways.begin(), ways.end());
  if (ways.empty()) return;
  std::printf(
      "%d starts: right after %.2f m median, %.2f m at 90 %%, %d wrong, %d not within 10 m\n",
      starts, ways[ways.size() / 2], ways[ways.size() * 9 / 10], wrong, never);
}

int run(const po::variables_map& given) {
  const config::Parameters parameters = config::loadParameters({});
  core::MapperOptions options;
  options.recognizer = parameters.match.recognizer;
  options.sonar = parameters.sonar;
  core::Mapper mapper(options);
  const auto drives = given["drive"].as<std::vector<std::string>>();
  const std::string out = given["out"].as<std::string>();
  std::map<core::PlaceId, core::Pose2d> truth_of;  ///< of the places of the first drive
  for (std::size_t number = 0; number < drives.size(); ++number) {
    const trials::Drive drive = trials::readDriveFile(drives[number]);
    const std::string prefix = out + (number == 0 ? "" : "_" + std::to_string(number + 1));
    std::ofstream online(prefix + "_T.csv"), final_way(prefix + "_S.csv");
    std::ofstream answers(prefix + "_R.csv"), truth(prefix + "_truth.csv");
    online << "t,x,y,yaw,lost\n";
    final_way << "t,x,y,yaw\n";
    truth << "t,x,y,yaw\n";
    answers << "t,decision,place,dx,dy,dyaw,belief,lost,reason\n";
    if (number > 0) {
      if (given.count("localize")) mapper.setMode(core::MapperMode::kLocalize);
      mapper.beginSession();
    }
    if (number > 0 && given.count("starts")) {
      localizeFromAnywhere(mapper, drive, truth_of, given["starts"].as<int>(),
                           given.count("no-compass") == 0, kStart + 100000.0);
      continue;
    }
    const double start = kStart + 100000.0 * static_cast<double>(number) - drive.front().t;
    const std::clock_t begin = std::clock();
    double way = 0.0;
    for (const trials::DriveMoment& moment : drive) {
      const double t = start + moment.t;
      if (moment.heading && !given.count("no-compass")) {
        mapper.addHeading(stampOf(t), *moment.heading);
      }
      mapper.addOdometry(stampOf(t), moment.odom);
      for (const core::SonarReading& reading : moment.readings) {
        mapper.addReading(stampOf(t), moment.odom, reading);
      }
      if (moment.truth) truth << rowOf(t, *moment.truth) << '\n';
      if (const auto map_from_odom = mapper.mapFromOdom()) {
        online << rowOf(t, *map_from_odom * moment.odom) << ',' << mapper.lost() << '\n';
      }
      writeAnswers(answers, mapper.takeDecisions());
      if (&moment != &drive.front()) {
        const core::Pose2d& last = (&moment - 1)->odom;
        way += std::hypot(moment.odom.x - last.x, moment.odom.y - last.y);
      }
    }
    const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::printf(
        "%s: %.1f m, %.2f ms a metre, %zu nodes, %zu ties, %zu places, bend %.2f deg/m, turn "
        "factor %.3f\n",
        drives[number].c_str(), way, 1000.0 * cpu / way, mapper.graph().nodes().size(),
        mapper.graph().ties().size(), mapper.places().size(),
        mapper.graph().errors().bend * 180.0 / core::kPi, mapper.graph().errors().turn_factor);
    const core::FinalWay at_end(mapper.graph().nodes(), mapper.firstOfDrive());
    for (const trials::DriveMoment& moment : drive) {
      final_way << rowOf(start + moment.t, at_end.at(stampOf(start + moment.t), moment.odom))
                << '\n';
    }
    for (const core::MappedPlace& place : mapper.places()) {
      const auto made = std::lower_bound(
          drive.begin(), drive.end(), seconds(place.stamp) - start,
          [](const trials::DriveMoment& moment, double t) { return moment.t < t - 1e-6; });
      if (number == 0 && made != drive.end() && made->truth) truth_of[place.id] = *made->truth;
    }
    std::ofstream map(prefix + "_M.csv");
    map << "id,label,t,x,y,yaw\n";
    for (const core::MappedPlace& place : mapper.places()) {
      if (place.apart) continue;
      map << place.id << ',' << place.label << ','
          << rowOf(seconds(place.stamp), place.map_from_base) << '\n';
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    po::options_description options("usage: place_memory_drive --drive F.jsonl.gz... --out PREFIX");
    options.add_options()("help", "show this")(
        "drive", po::value<std::vector<std::string>>()->required()->multitoken(),
        "drives, one session each")("out", po::value<std::string>()->required(),
                                    "prefix of the tables _T, _S, _M, _R, _truth.csv")(
        "no-compass", "without the compass")("starts", po::value<int>(),
                                             "on the second drive so often from nothing")(
        "localize", "drives from the second on change nothing");
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, options), given);
    if (given.count("help")) {
      std::cout << options;
      return 0;
    }
    po::notify(given);
    return run(given);
  } catch (const std::exception& error) {
    std::cerr << "place_memory_drive: " << error.what() << '\n';
    return 1;
  }
}
