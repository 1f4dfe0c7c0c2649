// Replays a drive through the mapper and writes tables of what it made of it.

#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/load_parameters.h"
#include "core/mapping/final_way.h"
#include "core/mapping/mapper.h"
#include "trials/drive_file.h"
#include "trials/lab_program.h"

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

using Decisions = std::map<std::chrono::nanoseconds, core::ScanDecision>;

void writeAnswers(std::ofstream& table, const Decisions& decisions) {
  for (const auto& [stamp, decision] : decisions) {
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
    table << ',' << decision.belief << ',' << decision.lost << ",\"" << decision.reason << "\"\n";
  }
}

int run(const po::variables_map& given) {
  const config::Parameters parameters = config::loadParameters({});
  core::MapperOptions options;
  options.recognizer = parameters.match.recognizer;
  options.sonar = parameters.sonar;
  options.keep_way = true;
  core::Mapper mapper(options);
  const auto drives = given["drive"].as<std::vector<std::string>>();
  const std::string out = given["out"].as<std::string>();
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
    const double start = kStart + 100000.0 * static_cast<double>(number) - drive.front().t;
    const std::clock_t begin = std::clock();
    double way = 0.0;
    Decisions decisions;
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
      for (const core::ScanDecision& decision : mapper.takeDecisions()) {
        decisions[decision.stamp] = decision;
      }
      if (&moment != &drive.front()) {
        const core::Pose2d& last = (&moment - 1)->odom;
        way += std::hypot(moment.odom.x - last.x, moment.odom.y - last.y);
      }
    }
    writeAnswers(answers, decisions);
    const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::printf(
        "%s: %.1f m, %.2f ms a metre, %zu nodes, %zu ties, %zu places, bend %.2f "
        "+- %.2f, turn factor %.3f +- %.3f\n",
        drives[number].c_str(), way, 1000.0 * cpu / way, mapper.graph().nodes().size(),
        mapper.graph().ties().size(), mapper.places().size(),
        mapper.odometryErrors().bend * 180.0 / core::kPi,
        mapper.odometryErrorSigmas().bend * 180.0 / core::kPi, mapper.odometryErrors().turn_factor,
        mapper.odometryErrorSigmas().turn_factor);
    const core::FinalWay at_end(mapper.way());
    for (const trials::DriveMoment& moment : drive) {
      final_way << rowOf(start + moment.t, at_end.at(stampOf(start + moment.t), moment.odom))
                << '\n';
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
  po::options_description options("usage: place_memory_drive --drive F.jsonl.gz... --out PREFIX");
  options.add_options()("help", "show this")(
      "drive", po::value<std::vector<std::string>>()->required()->multitoken(),
      "drives, one session each")("out", po::value<std::string>()->required(),
                                  "prefix of the tables _T, _S, _M, _R, _truth.csv")(
      "no-compass", "without the compass")("localize", "drives from the second on change nothing");
  return place_memory::trials::runProgram("place_memory_drive", argc, argv, options, run);
}
