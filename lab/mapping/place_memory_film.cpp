// Replays a drive through the mapper and draws the map: at the end, and before and after the loop
// closure that moved it most.

#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <deque>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/load_parameters.h"
#include "config/memory_options.h"
#include "core/mapping/final_way.h"
#include "core/mapping/mapper.h"
#include "picture/kept_map_picture.h"
#include "trials/drive_file.h"
#include "trials/lab_program.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

constexpr double kEarlier = 15.0;  // of the first panel, before the closure [m]

std::chrono::nanoseconds stampOf(double t) {
  return std::chrono::nanoseconds(std::llround((1000.0 + t) * 1e9));
}

/// The map as it was after so many moments of the drive.
struct Moment {
  core::KeptMap map;
  std::size_t moments = 0;
  double way = 0.0;  ///< driven until then [m]
};

struct Film {
  std::vector<Moment> panels;  ///< some metres before the closure, before it, after it
  double moved = 0.0;          ///< by it, the node that moved furthest [m]
};

double furthestMove(const core::KeptMap& before, const core::KeptMap& after) {
  double furthest = 0.0;
  const std::size_t nodes = std::min(before.nodes.size(), after.nodes.size());
  for (std::size_t i = 0; i < nodes; ++i) {
    const core::Pose2d& a = before.nodes[i].pose;
    const core::Pose2d& b = after.nodes[i].pose;
    furthest = std::max(furthest, std::hypot(a.x - b.x, a.y - b.y));
  }
  return furthest;
}

/// Drives the whole way, and remembers the moments around each closure.
class Filming {
 public:
  Filming(const trials::Drive& drive, const core::MapperOptions& options, bool compass)
      : drive_(drive), mapper_(options), compass_(compass) {}

  void run() {
    for (std::size_t i = 0; i < drive_.size(); ++i) {
      feed(drive_[i]);
      if (i > 0) {
        way_ += std::hypot(drive_[i].odom.x - drive_[i - 1].odom.x,
                           drive_[i].odom.y - drive_[i - 1].odom.y);
      }
      for (const core::ScanDecision& decision : mapper_.takeDecisions()) {
        remember(i + 1, decision.kind == core::ScanDecision::Kind::kClosed);
      }
    }
  }

  const std::optional<Film>& film() const { return film_; }
  Moment end() const { return {mapper_.map(), drive_.size(), way_}; }

 private:
  void feed(const trials::DriveMoment& moment) {
    const auto stamp = stampOf(moment.t - drive_.front().t);
    if (moment.heading && compass_) mapper_.addHeading(stamp, *moment.heading);
    mapper_.addOdometry(stamp, moment.odom);
    for (const core::SonarReading& reading : moment.readings) {
      mapper_.addReading(stamp, moment.odom, reading);
    }
  }

  void remember(std::size_t moments, bool is_closed) {
    recent_.push_back({mapper_.map(), moments, way_});
    while (recent_.front().way < way_ - kEarlier) recent_.pop_front();
    if (!is_closed || recent_.size() < 3) return;
    const Moment& before = recent_[recent_.size() - 2];
    const double moved = furthestMove(before.map, recent_.back().map);
    if (!film_ || moved > film_->moved) {
      film_ = Film{{recent_.front(), before, recent_.back()}, moved};
    }
  }

  const trials::Drive& drive_;
  core::Mapper mapper_;
  const bool compass_;
  double way_ = 0.0;
  std::deque<Moment> recent_;
  std::optional<Film> film_;
};

picture::DrawnMap drawn(const Moment& moment, const trials::Drive& drive,
                        const config::Parameters& parameters) {
  picture::DrawnMap map = picture::drawnMap(
      moment.map, {config::fusedMapOptions(parameters), parameters.grid, parameters.sonar},
      [](core::PlaceId id) { return std::to_string(id); });
  const core::FinalWay way(moment.map.nodes, 0);
  if (way.empty()) return map;
  std::vector<core::Pose2d> poses;
  for (std::size_t i = 0; i < moment.moments; ++i) {
    poses.push_back(way.at(stampOf(drive[i].t - drive.front().t), drive[i].odom));
  }
  map.ways.push_back(std::move(poses));
  return map;
}

/// What any of the maps shows, so that they can be compared.
picture::Window common(const std::vector<picture::DrawnMap>& maps) {
  picture::Window window = picture::windowOf(maps.front());
  for (const picture::DrawnMap& map : maps) {
    const picture::Window other = picture::windowOf(map);
    window.lower_left = {std::min(window.lower_left.x, other.lower_left.x),
                         std::min(window.lower_left.y, other.lower_left.y)};
    window.upper_right = {std::max(window.upper_right.x, other.upper_right.x),
                          std::max(window.upper_right.y, other.upper_right.y)};
  }
  return window;
}

int run(const po::variables_map& given) {
  const config::Parameters parameters = config::loadParameters({});
  core::MapperOptions options;
  options.recognizer = parameters.match.recognizer;
  options.sonar = parameters.sonar;
  const trials::Drive drive = trials::readDriveFile(given["drive"].as<std::string>());
  const std::string out = given["out"].as<std::string>();
  Filming filming(drive, options, given.count("no-compass") == 0);
  filming.run();
  picture::writeMapPicture(drawn(filming.end(), drive, parameters), out + ".png");
  if (!filming.film()) {
    std::cout << "no loop was closed\n";
    return 0;
  }
  const Film& film = *filming.film();
  std::vector<picture::DrawnMap> maps;
  for (const Moment& panel : film.panels) maps.push_back(drawn(panel, drive, parameters));
  const picture::Window window = common(maps);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    maps[i].window = window;
    const std::string path = out + "_film_" + std::to_string(i + 1) + ".png";
    picture::writeMapPicture(maps[i], path);
    std::cout << path << ": after " << std::lround(film.panels[i].way) << " m\n";
  }
  std::cout << "the closure moved the map by up to " << film.moved << " m\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  po::options_description options("usage: place_memory_film --drive F.jsonl.gz --out PREFIX");
  options.add_options()("help", "show this")("drive", po::value<std::string>()->required(),
                                             "drive to replay")(
      "out", po::value<std::string>()->required(),
      "prefix of the pictures: .png at the end, _film_1.png to _film_3.png around a closure")(
      "no-compass", "without the compass");
  return place_memory::trials::runProgram("place_memory_film", argc, argv, options, run);
}
