#include "tools/drive_run.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "config/memory_options.h"
#include "core/mapping/final_way.h"
#include "core/mapping/mapper.h"
#include "core/memory/driven_map.h"
#include "picture/kept_map_picture.h"
#include "tools/drive_reader.h"
#include "tools/drive_tables.h"

namespace place_memory::tools {
namespace {

using std::chrono::nanoseconds;

// No robot that maps by sonars drives or turns faster: odometry started anew, or was set.
constexpr double kFastest = 5.0;       // [m/s]
constexpr double kLeastJump = 0.5;     // [m]
constexpr double kFastestTurn = 10.0;  // [rad/s]
constexpr double kLeastTurn = 1.0;     // [rad]

struct OdometryMoment {
  nanoseconds stamp{0};
  core::Pose2d odom_from_base;
};

bool jumps(const OdometryMoment& from, const OdometryMoment& to) {
  const core::Pose2d motion = from.odom_from_base.inverse() * to.odom_from_base;
  const double seconds = std::chrono::duration<double>(to.stamp - from.stamp).count();
  return std::hypot(motion.x, motion.y) > std::max(kLeastJump, kFastest * seconds) ||
         std::abs(motion.yaw) > std::max(kLeastTurn, kFastestTurn * seconds);
}

core::MapperOptions mapperOptions(const config::Parameters& parameters, const std::string& mode) {
  core::MapperOptions options;
  options.mode = mode == "map" ? core::MapperMode::kMap : core::MapperMode::kLocalize;
  options.cell_size = parameters.grid.cell_size;
  options.sonar = parameters.sonar;
  options.recognizer = parameters.match.recognizer;
  return options;
}

/// Feeds the mapper, and writes down what it says as it comes.
class Drive : public DriveListener {
 public:
  Drive(core::Mapper& mapper, DriveTable& trajectory, DriveTable& answers)
      : mapper_(mapper), trajectory_(trajectory), answers_(answers) {}

  void onHeading(nanoseconds stamp, double yaw) override { headings_.emplace_back(stamp, yaw); }

  void onReading(nanoseconds stamp, const core::Pose2d& odom_from_base,
                 const core::SonarReading& reading) override {
    readings_.push_back({stamp, odom_from_base, reading});
  }

  // What lies between two poses of which one jumped has no pose: it is left out.
  void onOdometry(nanoseconds stamp, const core::Pose2d& odom_from_base) override {
    const OdometryMoment now{stamp, odom_from_base};
    if (!way_.empty() && jumps(way_.back(), now)) {
      mapper_.beginSession();
      ++resets_;
      readings_.clear();
    } else if (!way_.empty()) {
      const core::Pose2d& last = way_.back().odom_from_base;
      length_ += std::hypot(odom_from_base.x - last.x, odom_from_base.y - last.y);
    }
    for (const auto& [heading_stamp, yaw] : headings_) mapper_.addHeading(heading_stamp, yaw);
    headings_.clear();
    for (const Reading& reading : readings_) {
      mapper_.addReading(reading.stamp, reading.odom_from_base, reading.reading);
    }
    readings_.clear();
    mapper_.addOdometry(stamp, odom_from_base);
    way_.push_back(now);
    std::optional<core::Pose2d> map_from_base = mapper_.mapFromOdom();
    if (map_from_base) map_from_base = *map_from_base * odom_from_base;
    trajectory_.add(trajectoryRow(stamp, map_from_base, mapper_.lost()));
    for (const core::ScanDecision& decision : mapper_.takeDecisions()) {
      answers_.add(answerRow(decision));
      ++decisions_[core::nameOf(decision.kind)];
    }
  }

  const std::vector<OdometryMoment>& way() const { return way_; }
  double length() const { return length_; }
  int resets() const { return resets_; }
  const std::map<std::string, int>& decisions() const { return decisions_; }

 private:
  struct Reading {
    nanoseconds stamp;
    core::Pose2d odom_from_base;
    core::SonarReading reading;
  };

  core::Mapper& mapper_;
  DriveTable& trajectory_;
  DriveTable& answers_;
  std::vector<std::pair<nanoseconds, double>> headings_;  ///< since the newest odometry
  std::vector<Reading> readings_;                         ///< likewise
  std::vector<OdometryMoment> way_;
  double length_ = 0.0;  ///< [m]
  int resets_ = 0;
  std::map<std::string, int> decisions_;
};

void takeUp(const core::DrivenMap& store, const std::string& path, core::Mapper& mapper) {
  for (const std::string& sentence : store.setAside()) std::cerr << sentence << '\n';
  if (store.kept().nodes.empty()) return;
  try {
    mapper.restore(store.kept());
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("the map in the store " + path +
                             " cannot be taken up: " + error.what() +
                             "; name another store, or take a copy of this one from before");
  }
}

std::optional<core::DrivenMap> openStore(const DriveArguments& arguments,
                                         const config::Parameters& parameters) {
  const bool localize = arguments.mode == "localize";
  if (parameters.store.empty()) {
    if (!localize) return std::nullopt;
    throw std::runtime_error(
        "--mode localize needs a map: --store names the file in which --mode map kept one");
  }
  if (localize && !std::filesystem::exists(parameters.store)) {
    throw std::runtime_error("--mode localize needs a map, but there is no store " +
                             parameters.store + "; --mode map makes one");
  }
  core::StoreOpening opening;
  opening.progress = [](const std::string& sentence) { std::cerr << sentence << '\n'; };
  std::optional<core::DrivenMap> store;
  store.emplace(parameters.store, parameters.grid.cell_size, parameters.sonar, opening);
  if (localize && store->kept().nodes.empty()) {
    throw std::runtime_error("--mode localize needs a map, but the store " + parameters.store +
                             " holds no place whose readings are known; --mode map makes some");
  }
  return store;
}

std::string counted(std::size_t number, const std::string& things) {
  return std::to_string(number) + " " + things;
}

void tell(const Drive& drive, const core::Mapper& mapper, const DriveLosses& losses) {
  std::string decisions;
  for (const auto& [name, count] : drive.decisions()) {
    decisions += (decisions.empty() ? "" : ", ") + std::to_string(count) + " " + name;
  }
  std::size_t places = 0, apart = 0;
  for (const core::MappedPlace& place : mapper.places()) ++(place.apart ? apart : places);
  char length[32];
  std::snprintf(length, sizeof length, "%.1f m", drive.length());
  std::cerr << length << ", " << counted(losses.readings, "readings")
            << "; scans: " << (decisions.empty() ? "none" : decisions) << "; "
            << counted(places, "places");
  if (apart > 0) std::cerr << ", and " << apart << " that are not joined to the map";
  if (drive.resets() > 0) std::cerr << "; odometry started anew " << drive.resets() << " times";
  const std::string rejected = node::inWords(losses.rejected);
  if (!rejected.empty()) std::cerr << "; readings left out: " << rejected;
  if (!losses.problem.empty()) std::cerr << " (" << losses.problem << ")";
  std::cerr << '\n';
}

picture::MapMaking mapMaking(const config::Parameters& parameters) {
  return {config::fusedMapOptions(parameters), parameters.grid, parameters.sonar};
}

std::vector<core::Pose2d> wayOf(const Drive& drive, const core::FinalWay& way) {
  std::vector<core::Pose2d> poses;
  for (const OdometryMoment& moment : drive.way()) {
    poses.push_back(way.at(moment.stamp, moment.odom_from_base));
  }
  return poses;
}

}  // namespace

void runDrive(const BagSet& bags, BagScanner& scanner, const DriveArguments& arguments,
              const config::Parameters& parameters) {
  core::Mapper mapper(mapperOptions(parameters, arguments.mode));
  std::optional<core::DrivenMap> store = openStore(arguments, parameters);
  if (store) takeUp(*store, parameters.store, mapper);
  DriveTable trajectory(arguments.trajectory, kTrajectoryHeader);
  DriveTable final_way(arguments.final_way, kFinalHeader);
  DriveTable map(arguments.map, kMapHeader);
  DriveTable answers(arguments.answers, kAnswersHeader);
  if (!arguments.png.empty())
    picture::writeMapPicture({}, arguments.png);  // tells at once if it cannot

  Drive drive(mapper, trajectory, answers);
  const DriveLosses losses = readDrive(bags, scanner, parameters, drive);
  if (store && arguments.mode == "map") store->keep(mapper.map());
  const core::FinalWay way(mapper.graph().nodes(), mapper.firstOfDrive());
  if (!way.empty()) {
    for (const OdometryMoment& moment : drive.way()) {
      final_way.add(finalRow(moment.stamp, way.at(moment.stamp, moment.odom_from_base)));
    }
  }
  const auto label_of = [&store](core::PlaceId id) {
    const std::string label = store ? store->labelOf(id) : std::string();
    return label.empty() ? "place_" + std::to_string(id) : label;
  };
  for (const core::MappedPlace& place : mapper.places()) {
    if (!place.apart) map.add(mapRow(place, label_of(place.id)));
  }
  if (!arguments.png.empty()) {
    picture::DrawnMap drawn = drawnMap(mapper.map(), mapMaking(parameters), label_of);
    if (!way.empty()) drawn.ways.push_back(wayOf(drive, way));
    writeMapPicture(drawn, arguments.png);
  }
  for (DriveTable* table : {&trajectory, &final_way, &map, &answers}) table->close();
  tell(drive, mapper, losses);
}

}  // namespace place_memory::tools
