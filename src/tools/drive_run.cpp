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

#include "config/mapper_options.h"
#include "config/memory_options.h"
#include "core/mapping/final_way.h"
#include "core/mapping/mapper.h"
#include "node/drive/mapper_feed.h"
#include "place_memory/core/place_memory.h"
#include "tools/drive_reader.h"
#include "tools/drive_tables.h"

namespace place_memory::tools {
namespace {

/// Writes down what the mapper says as it is fed.
class DriveRecord {
 public:
  DriveRecord(core::Mapper& mapper, DriveTable& trajectory, DriveTable& answers)
      : mapper_(mapper), trajectory_(trajectory), answers_(answers) {}

  void add(const node::OdometryMoment& now, bool jumped) {
    if (jumped) {
      ++resets_;
    } else if (!way_.empty()) {
      const core::Pose2d& last = way_.back().odom_from_base;
      length_ += std::hypot(now.odom_from_base.x - last.x, now.odom_from_base.y - last.y);
    }
    way_.push_back(now);
    std::optional<core::Pose2d> map_from_base = mapper_.mapFromOdom();
    if (map_from_base) map_from_base = *map_from_base * now.odom_from_base;
    trajectory_.add(trajectoryRow(now.stamp, map_from_base, mapper_.lost()));
    for (const core::ScanDecision& decision : mapper_.takeDecisions()) {
      answers_.add(answerRow(decision));
      ++decisions_[core::nameOf(decision.kind)];
    }
  }

  const std::vector<node::OdometryMoment>& way() const { return way_; }
  double length() const { return length_; }
  int resets() const { return resets_; }
  const std::map<std::string, int>& decisions() const { return decisions_; }

 private:
  core::Mapper& mapper_;
  DriveTable& trajectory_;
  DriveTable& answers_;
  std::vector<node::OdometryMoment> way_;
  double length_ = 0.0;  ///< [m]
  int resets_ = 0;
  std::map<std::string, int> decisions_;
};

core::KeptMap takeUp(core::PlaceMemory& memory, const std::string& path, core::Mapper& mapper) {
  for (const std::string& sentence : memory.storeHealth().set_aside) std::cerr << sentence << '\n';
  core::KeptMap kept = memory.drivenMap();
  if (kept.nodes.empty()) return kept;
  try {
    mapper.restore(kept);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("the map in the store " + path +
                             " cannot be taken up: " + error.what() +
                             "; name another store, or take a copy of this one from before");
  }
  return kept;
}

/// Where a map is to be localized in there has to be one.
void requireStore(const config::Parameters& parameters) {
  if (parameters.store.empty()) {
    throw std::runtime_error(
        "--mode localize needs a map: --store names the file in which --mode map kept one");
  }
  if (!std::filesystem::exists(parameters.store)) {
    throw std::runtime_error("--mode localize needs a map, but there is no store " +
                             parameters.store + "; --mode map makes one");
  }
}

std::string counted(std::size_t number, const std::string& things) {
  return std::to_string(number) + " " + things;
}

void tell(const DriveRecord& drive, const core::Mapper& mapper, const node::DriveLosses& losses) {
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

}  // namespace

void runDrive(const BagSet& bags, BagScanner& scanner, const DriveArguments& arguments,
              const config::Parameters& parameters) {
  const bool localize = arguments.mode == "localize";
  if (localize) requireStore(parameters);
  core::Mapper mapper(config::mapperOptions(
      parameters, localize ? core::MapperMode::kLocalize : core::MapperMode::kMap));
  core::PlaceMemoryOptions options = config::memoryOptions(parameters);
  options.opening.progress = [](const std::string& sentence) { std::cerr << sentence << '\n'; };
  std::chrono::nanoseconds now{0};
  options.clock = [&now] { return now; };
  core::PlaceMemory memory(options);
  const core::KeptMap kept = takeUp(memory, parameters.store, mapper);
  if (localize && kept.nodes.empty()) {
    throw std::runtime_error("--mode localize needs a map, but the store " + parameters.store +
                             " holds no place whose readings are known; --mode map makes some");
  }
  DriveTable trajectory(arguments.trajectory, kTrajectoryHeader);
  DriveTable final_way(arguments.final_way, kFinalHeader);
  DriveTable map(arguments.map, kMapHeader);
  DriveTable answers(arguments.answers, kAnswersHeader);

  DriveRecord drive(mapper, trajectory, answers);
  node::MapperFeed feed(mapper, [&drive](const node::OdometryMoment& moment, bool jumped) {
    drive.add(moment, jumped);
  });
  const node::DriveLosses losses = readDrive(bags, scanner, parameters, feed);
  if (!drive.way().empty()) now = drive.way().back().stamp;
  if (!localize) memory.keep(mapper.map());
  const core::FinalWay way(mapper.graph().nodes(), mapper.firstOfDrive());
  if (!way.empty()) {
    for (const node::OdometryMoment& moment : drive.way()) {
      final_way.add(finalRow(moment.stamp, way.at(moment.stamp, moment.odom_from_base)));
    }
  }
  for (const core::MappedPlace& place : mapper.places()) {
    const std::optional<core::Place> known = memory.place(place.id);
    if (!place.apart) map.add(mapRow(place, known ? known->label : place.label));
  }
  for (DriveTable* table : {&trajectory, &final_way, &map, &answers}) table->close();
  tell(drive, mapper, losses);
}

}  // namespace place_memory::tools
