// Mapping drives, with all the sonars or some.
#include <cmath>
#include <string>
#include <vector>

#include "mapping/drive_table.h"
#include "mapping/mapping_figures.h"
#include "mapping/mapping_worlds.h"
#include "mapping/suites.h"

namespace place_memory::mapping {
namespace {

/// Of the ring of sixteen.
std::vector<int> ring(int step) {
  std::vector<int> sonars;
  for (int i = 0; i < 16; i += step) sonars.push_back(i);
  return sonars;
}

const std::vector<int> kAhead{0, 1, 2, 3, 4, 12, 13, 14, 15};

MappingFigures mapped(const SuiteOptions& options, const sim::World& world, std::uint64_t seed,
                      const std::vector<int>& sonars) {
  trials::DriveRecipe recipe = recipeOf(options);
  recipe.sonars = sonars;
  core::Mapper mapper(mapperOptions());
  Truth truth;
  DrivePart part;
  part.compass = options.compass;
  const MappingRun run = drive(mapper, trials::simulateDrive(world, {}, recipe, seed), part, truth);
  return figures(mapper, run, truth);
}

experiments::Table tableOf(const SuiteOptions& options,
                           const std::vector<std::pair<std::string, std::vector<int>>>& rings) {
  experiments::Table table(driveHeader());
  for (const std::string& name : options.names) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      const sim::World world = mappingWorld(name, seed, options.worlds);
      for (const auto& [sonars, indices] : rings) {
        table.add(driveRow(name + " " + std::to_string(seed), sonars,
                           mapped(options, world, seed, indices)));
      }
    }
  }
  return table;
}

experiments::Table sumsOf(const SuiteOptions& options) {
  experiments::Table table(sumsHeader());
  for (const std::string& name : options.names) {
    std::vector<MappingFigures> runs;
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      runs.push_back(mapped(options, mappingWorld(name, seed, options.worlds), seed, ring(1)));
    }
    table.add(sumsRow(name, runs));
  }
  return table;
}

}  // namespace

trials::DriveRecipe recipeOf(const SuiteOptions& options) {
  trials::DriveRecipe recipe;
  recipe.way = options.way;
  recipe.scale_sigma = options.noise.scale_sigma;
  recipe.yaw_noise = options.noise.yaw_noise;
  if (!options.compass) recipe.compass_sigma = -1.0;
  return recipe;
}

experiments::Table driveSuite(const SuiteOptions& options) {
  if (options.sums) return sumsOf(options);
  return tableOf(options, {{"16", ring(1)}});
}

experiments::Table sonarSuite(const SuiteOptions& options) {
  return tableOf(options, {{"8", ring(2)}, {"4", ring(4)}, {"9 ahead", kAhead}});
}

}  // namespace place_memory::mapping
