// Mapping drives, with all the sonars or some.
#include <cmath>
#include <string>
#include <vector>

#include "mapping/mapping_figures.h"
#include "mapping/mapping_worlds.h"
#include "mapping/suites.h"

namespace place_memory::mapping {
namespace {

using experiments::fixed;

const std::vector<std::string> kHeader{"world",      "sonars", "way",     "online",     "final",
                                       "scale free", "places", "doubled", "false ties", "wrong",
                                       "of",         "median", "99 %",    "revisits",   "ms by m"};

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0 ? "" : fixed(static_cast<double>(part) / static_cast<double>(whole), 3);
}

std::vector<std::string> row(const std::string& world, const std::string& sonars,
                             const MappingFigures& found) {
  return {world,
          sonars,
          fixed(found.way, 0),
          fixed(found.online, 3),
          fixed(found.final, 3),
          fixed(found.final_scale_free, 3),
          std::to_string(found.places),
          std::to_string(found.doubled),
          std::to_string(found.false_ties),
          std::to_string(found.wrong),
          std::to_string(found.answers),
          fixed(found.median(), 3),
          fixed(found.p99(), 3),
          share(found.known, found.again),
          fixed(found.cpu, 1)};
}

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
  experiments::Table table(kHeader);
  for (const std::string& name : options.names) {
    for (int i = 0; i < options.seeds; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
      const sim::World world = mappingWorld(name, seed, options.worlds);
      for (const auto& [sonars, indices] : rings) {
        table.add(
            row(name + " " + std::to_string(seed), sonars, mapped(options, world, seed, indices)));
      }
    }
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
  return tableOf(options, {{"16", ring(1)}});
}

experiments::Table sonarSuite(const SuiteOptions& options) {
  return tableOf(options, {{"8", ring(2)}, {"4", ring(4)}, {"9 ahead", kAhead}});
}

}  // namespace place_memory::mapping
