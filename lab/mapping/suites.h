#ifndef PLACE_MEMORY_MAPPING_SUITES_H
#define PLACE_MEMORY_MAPPING_SUITES_H

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "experiments/table.h"
#include "mapping/mapping_run.h"
#include "sim/world/world.h"
#include "trials/simulated_drive.h"

namespace place_memory::mapping {

/// What all suites are told.
struct SuiteOptions {
  std::string worlds;  ///< folder of world files
  std::vector<std::string> names{"office",    "hallway",    "corridor",
                                 "open_plan", "laboratory", "home"};
  std::uint64_t first_seed = 1000;
  int seeds = 3;
  std::vector<std::string> drives;  ///< files of recorded ones
  double way = 200.0;               ///< [m]
  bool compass = true;
  bool sums = false;  ///< a row for all seeds together
  OdometryNoise noise;
};

/// A way through a world, with the odometry that is asked for.
trials::DriveRecipe recipeOf(const SuiteOptions& options);

/// Robots that map: sixteen sonars.
experiments::Table driveSuite(const SuiteOptions& options);
/// The same with 8 and 4 sonars all around, and the forward nine.
experiments::Table sonarSuite(const SuiteOptions& options);
/// Corridors driven out and back with eight sonars that look ahead, raw odometry and no compass.
experiments::Table outAndBackSuite(const SuiteOptions& options);
/// A way through a world on which the robot is carried away again and again.
trials::Drive carriedDrive(const SuiteOptions& options, const std::string& world,
                           std::uint64_t seed);

/// What scans say of whether a robot is lost, fitted; the model in lost_estimate.cpp.
experiments::Table lostFit(const SuiteOptions& options);
/// Robots that are carried away while they map.
experiments::Table kidnapSuite(const SuiteOptions& options);
/// Robots put down anywhere in a building that is mapped.
experiments::Table startSuite(const SuiteOptions& options);
/// Second sessions in the same building, and in strangers'.
experiments::Table sessionSuite(const SuiteOptions& options);
/// False links put into maps.
experiments::Table linkSuite(const SuiteOptions& options);
/// Long drives about one building while doors and chairs change.
experiments::Table soakSuite(const SuiteOptions& options);

/// Recorded drives whose odometry is made to err: a row a drive, over all seeds.
experiments::Table recordedSuite(const SuiteOptions& options);
/// Halves of them as two sessions, and as sessions in strangers' buildings.
experiments::Table halvesSuite(const SuiteOptions& options);

/// All of them by name.
const std::map<std::string, std::function<experiments::Table(const SuiteOptions&)>>& suites();

}  // namespace place_memory::mapping

#endif  // PLACE_MEMORY_MAPPING_SUITES_H
