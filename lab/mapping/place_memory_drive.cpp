// Replays a drive through the mapper and writes tables of what it made of it.

#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "config/load_parameters.h"
#include "core/mapping/mapper.h"
#include "trials/drive_file.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

constexpr double kStart = 1000.0;  // stamp of the first moment [s]

std::chrono::nanoseconds stampOf(double t) {
  return std::chrono::nanoseconds(std::llround(t * 1e9));
}

double seconds(std::chrono::nanoseconds stamp) {
  return static_cast<double>(stamp.count()) * 1e-9;
}

std::string rowOf(double t, const core::Pose2d& pose) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3f,%.4f,%.4f,%.5f", t, pose.x, pose.y, pose.yaw);
  return text;
}

/// The way of the robot as the map lies at the end.
class FinalWay {
 public:
  explicit FinalWay(const core::ScanGraph& graph) {
    for (const core::ScanNode& node : graph.nodes()) {
      if (node.session == 1) nodes_.push_back(&node);
    }
  }

  core::Pose2d at(double t, const core::Pose2d& odom) const {
    std::size_t after = 0;
    while (after < nodes_.size() && seconds(nodes_[after]->stamp) < t) ++after;
    const auto by = [&](std::size_t i) {
      return nodes_[i]->pose * (nodes_[i]->odom_from_base.inverse() * odom);
    };
    if (after == 0) return by(0);
    if (after == nodes_.size()) return by(after - 1);
    const double first = seconds(nodes_[after - 1]->stamp), last = seconds(nodes_[after]->stamp);
    const double share = (t - first) / std::max(last - first, 1e-9);
    const core::Pose2d a = by(after - 1), b = by(after);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
            core::wrapAngle(a.yaw + share * core::wrapAngle(b.yaw - a.yaw))};
  }

 private:
  std::vector<const core::ScanNode*> nodes_;
};

void writeAnswers(std::ofstream& table, const std::vector<core::ScanDecision>& decisions) {
  for (const core::ScanDecision& decision : decisions) {
    table << rowOf(seconds(decision.stamp), {}).substr(0, rowOf(seconds(decision.stamp), {}).find(','))
          << ',' << core::nameOf(decision.kind) << ',';
    if (decision.place != core::kNoPlace) {
      const core::Pose2d& pose = decision.place_from_base;
      char text[96];
      std::snprintf(text, sizeof text, "%lld,%.4f,%.4f,%.5f", static_cast<long long>(decision.place),
                    pose.x, pose.y, pose.yaw);
      table << text;
    } else {
      table << ",,,";
    }
    table << ',' << decision.belief << ',' << decision.lost << ',' << decision.reason << '\n';
  }
}

int run(const po::variables_map& given) {
  const config::Parameters parameters = config::loadParameters({});
  core::MapperOptions options;
  options.recognizer = parameters.match.recognizer;
  options.sonar = parameters.sonar;
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
    std::printf("%s: %.1f m, %.2f ms a metre, %zu nodes, %zu ties, %zu places, bend %.2f deg/m, turn factor %.3f\n",
                drives[number].c_str(), way, 1000.0 * cpu / way, mapper.graph().nodes().size(),
                mapper.graph().ties().size(), mapper.places().size(),
                mapper.graph().errors().bend * 180.0 / core::kPi,
                mapper.graph().errors().turn_factor);
    const FinalWay at_end(mapper.graph());
    for (const trials::DriveMoment& moment : drive) {
      final_way << rowOf(start + moment.t, at_end.at(start + moment.t, moment.odom)) << '\n';
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
        "no-compass", "without the compass")("localize", "drives from the second on change nothing");
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
