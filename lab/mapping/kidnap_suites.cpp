// Robots that somebody carries away, and robots that are switched on somewhere.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mapping/mapping_figures.h"
#include "mapping/mapping_worlds.h"
#include "mapping/suites.h"
#include "sim/world/random.h"

namespace place_memory::mapping {
namespace {

using core::Pose2d;
using experiments::fixed;

constexpr double kBetweenLosses = 40.0;  // way [m]
constexpr double kGiveUp = 10.0;         // [m]
constexpr int kStarts = 200;

/// Ways after which the first answer named a place, and whether it was right.
struct Start {
  double way = kGiveUp;
  bool named = false;
  bool right = false;
};

bool right(const core::Mapper& mapper, const core::ScanDecision& decision, const Truth& truth) {
  for (const core::MappedPlace& place : mapper.places()) {
    if (place.id != decision.place) continue;
    const Pose2d is = truth.at(place.stamp)->inverse() * *truth.at(decision.stamp);
    const Pose2d& said = decision.place_from_base;
    return std::hypot(is.x - said.x, is.y - said.y) <= 0.75 &&
           std::abs(core::wrapAngle(is.yaw - said.yaw)) <= 20.0 * core::kPi / 180.0;
  }
  return true;
}

Start startAt(core::Mapper& mapper, const trials::Drive& moments, DrivePart part, Truth truth) {
  Start start;
  mapper.beginSession();
  const std::size_t last = moments.size();
  double way = 0.0;
  for (std::size_t i = part.first; i < last && way < kGiveUp && !start.named; ++i) {
    part.first = i;
    part.last = i + 1;
    if (i > 0) {
      way += std::hypot(moments[i].odom.x - moments[i - 1].odom.x,
                        moments[i].odom.y - moments[i - 1].odom.y);
    }
    for (const DecisionRecord& record : drive(mapper, moments, part, truth).decisions) {
      if (record.decision.place == core::kNoPlace) continue;
      start = {way, true, right(mapper, record.decision, truth)};
      break;
    }
  }
  return start;
}

}  // namespace

trials::Drive carriedDrive(const SuiteOptions& options, const std::string& world,
                           std::uint64_t seed) {
  trials::DriveRecipe recipe = recipeOf(options);
  // Not before it knows the building.
  for (double at = 0.5 * recipe.way; at < recipe.way - 20.0; at += kBetweenLosses) {
    recipe.carried.push_back(at);
  }
  return trials::simulateDrive(mappingWorld(world, seed, options.worlds), {}, recipe, seed);
}

experiments::Table kidnapSuite(const SuiteOptions& options) {
  experiments::Table table({"world", "way", "carried", "said", "false alarms", "calibration error",
                            "wrong", "of", "final", "doubled"});
  LostFigures all;
  for (const std::string& name : options.names) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      core::Mapper mapper(mapperOptions());
      Truth truth;
      DrivePart part;
      part.compass = options.compass;
      const MappingRun run = drive(mapper, carriedDrive(options, name, seed), part, truth);
      LostFigures lost;
      lost.add(run);
      all.add(run);
      const MappingFigures found = figures(mapper, run, truth);
      table.add({name + " " + std::to_string(seed), fixed(found.way, 0),
                 std::to_string(lost.losses), std::to_string(lost.said),
                 std::to_string(lost.false_alarms), fixed(lost.calibrationError(), 3),
                 std::to_string(found.wrong), std::to_string(found.answers), fixed(found.final, 3),
                 std::to_string(found.doubled)});
    }
  }
  table.add({"all", fixed(all.way, 0), std::to_string(all.losses), std::to_string(all.said),
             std::to_string(all.false_alarms), fixed(all.calibrationError(), 3), "", "", "", ""});
  return table;
}

experiments::Table startSuite(const SuiteOptions& options) {
  experiments::Table table(
      {"world", "sonars", "starts", "median way", "90 %", "wrong", "not within 10 m"});
  for (const std::string& name : options.names) {
    for (const int step : {1, 4}) {
      const sim::World world = mappingWorld(name, options.first_seed, options.worlds);
      trials::DriveRecipe recipe = recipeOf(options);
      for (int sonar = 0; sonar < 16; sonar += step) recipe.sonars.push_back(sonar);
      core::Mapper mapper(mapperOptions());
      Truth truth;
      DrivePart part;
      part.compass = options.compass;
      drive(mapper, trials::simulateDrive(world, {}, recipe, options.first_seed), part, truth);
      mapper.setMode(core::MapperMode::kLocalize);
      recipe.changes = false;
      const trials::Drive again = trials::simulateDrive(world, {}, recipe, options.first_seed + 77);
      std::vector<double> ways;
      int wrong = 0, never = 0;
      for (int k = 0; k < kStarts; ++k) {
        part.start += 100000.0;
        part.first = again.size() * static_cast<std::size_t>(k) * 9 / 10 / kStarts;
        const Start start = startAt(mapper, again, part, truth);
        ways.push_back(start.way);
        never += start.named ? 0 : 1;
        wrong += start.named && !start.right ? 1 : 0;
      }
      std::sort(ways.begin(), ways.end());
      table.add({name, std::to_string(16 / step), std::to_string(kStarts),
                 fixed(ways[ways.size() / 2], 2), fixed(ways[ways.size() * 9 / 10], 2),
                 std::to_string(wrong), std::to_string(never)});
    }
  }
  return table;
}

}  // namespace place_memory::mapping
