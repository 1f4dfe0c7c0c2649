// Corridors driven out and back with sonars that look ahead: the way back sees all from the other
// side.
#include <string>
#include <utility>
#include <vector>

#include "mapping/drive_table.h"
#include "mapping/mapping_worlds.h"
#include "mapping/suites.h"
#include "trials/out_and_back.h"

namespace place_memory::mapping {
namespace {

constexpr double kDegree = core::kPi / 180.0;

/// Eight sonars on the front of a base, at bearings [degrees] from its x axis.
sim::SimulatedRobot robotWith(const std::vector<double>& bearings) {
  sim::SimulatedRobot robot;
  for (const double bearing : bearings) {
    robot.ring.mounts.push_back(core::Pose2d{0.0, 0.0, bearing * kDegree} *
                                core::Pose2d{robot.ring.radius, 0.0, 0.0});
  }
  robot.ring.count = static_cast<int>(bearings.size());
  return robot;
}

const std::vector<std::pair<std::string, std::vector<double>>> kFronts{
    {"8 in a fan", {-35, -25, -15, -5, 5, 15, 25, 35}},
    {"8 Pioneer", {-90, -50, -30, -10, 10, 30, 50, 90}},
    {"8 on 180", {-78.75, -56.25, -33.75, -11.25, 11.25, 33.75, 56.25, 78.75}}};

/// Raw wheels: what they err by, they err by all the way.
trials::DriveRecipe rawOdometry() {
  trials::DriveRecipe recipe;
  recipe.bend_sigma = 1.5 * kDegree;
  recipe.turn_factor_sigma = 0.05;
  recipe.compass_sigma = -1.0;
  return recipe;
}

}  // namespace

experiments::Table outAndBackSuite(const SuiteOptions& options) {
  experiments::Table table(driveHeader());
  const trials::DriveRecipe recipe = rawOdometry();
  for (const std::string& name : options.names) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      const sim::World world = mappingWorld(name, seed, options.worlds);
      for (const auto& [sonars, bearings] : kFronts) {
        const trials::Drive moments = trials::driveOutAndBack(world, robotWith(bearings), recipe,
                                                              trials::longestWay(world), seed);
        core::Mapper mapper(mapperOptions());
        Truth truth;
        const MappingRun run = drive(mapper, moments, {}, truth);
        table.add(driveRow(name + " " + std::to_string(seed), sonars, figures(mapper, run, truth)));
      }
    }
  }
  return table;
}

}  // namespace place_memory::mapping
