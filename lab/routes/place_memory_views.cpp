// Puts simulated robots down in buildings whose rooms look alike, and says how soon they know where
// they are: by the views that are suggested, and by going along any link.

#include <algorithm>
#include <boost/program_options.hpp>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "experiments/table.h"
#include "mapping/mapping_worlds.h"
#include "routes/view_trial.h"
#include "trials/lab_program.h"

namespace place_memory::routes {
namespace {

namespace po = boost::program_options;
using experiments::fixed;

double scansOf(const ViewCounts& counts) {
  return static_cast<double>(counts.scans) / std::max(counts.unsure, 1);
}

std::vector<std::string> row(const std::string& world, const std::string& seed,
                             const ViewCounts& advised, const ViewCounts& random) {
  return {world,
          seed,
          std::to_string(advised.unsure) + " of " + std::to_string(advised.starts),
          fixed(scansOf(advised), 2),
          fixed(scansOf(random), 2),
          fixed(scansOf(advised) / scansOf(random), 2),
          fixed((scansOf(advised) - 1.0) / (scansOf(random) - 1.0), 2),
          fixed(advised.way / std::max(advised.unsure, 1), 1),
          fixed(random.way / std::max(random.unsure, 1), 1),
          std::to_string(advised.unsure - advised.certain) + ", " +
              std::to_string(random.unsure - random.certain),
          std::to_string(advised.wrong) + ", " + std::to_string(random.wrong)};
}

int run(const po::variables_map& given) {
  ViewTrialRecipe recipe;
  recipe.starts = given["starts"].as<int>();
  experiments::Table table({"world", "seed", "unsure after the first scan", "scans, suggested",
                            "scans, at random", "ratio", "ratio after the first scan",
                            "driven [m], suggested", "driven [m], at random",
                            "never certain: suggested, at random", "wrong: suggested, at random"});
  for (const std::string& name : given["world"].as<std::vector<std::string>>()) {
    ViewCounts advised, random;
    for (int i = 0; i < given["seeds"].as<int>(); ++i) {
      const std::uint64_t seed =
          given["first-seed"].as<std::uint64_t>() + static_cast<std::uint64_t>(i);
      const sim::World world = mapping::mappingWorld(name, seed, given["worlds"].as<std::string>());
      const ViewCounts by_advice = findOneself(world, ViewPolicy::kAdvised, recipe, seed);
      const ViewCounts by_chance = findOneself(world, ViewPolicy::kRandom, recipe, seed);
      table.add(row(name, std::to_string(seed), by_advice, by_chance));
      advised.add(by_advice);
      random.add(by_chance);
    }
    table.add(row(name, "all", advised, random));
  }
  table.writeMarkdown(std::cout);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace place_memory::routes

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  using Names = std::vector<std::string>;
  po::options_description options("usage: place_memory_views");
  options.add_options()("help", "show this")("world",
                                             po::value<Names>()->multitoken()->default_value(
                                                 {"cells", "copied_cells"}, "cells copied_cells"),
                                             "names as place_memory_mapping has them")(
      "worlds", po::value<std::string>()->default_value("config/worlds"), "folder of world files")(
      "first-seed", po::value<std::uint64_t>()->default_value(1000), "")(
      "seeds", po::value<int>()->default_value(10), "buildings of each kind")(
      "starts", po::value<int>()->default_value(20), "in each of them");
  return place_memory::trials::runProgram("place_memory_views", argc, argv, options,
                                          place_memory::routes::run);
}
