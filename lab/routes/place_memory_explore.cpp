// Simulated robots explore buildings with an empty map, and a table says how well.

#include <algorithm>
#include <boost/program_options.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "config/load_parameters.h"
#include "config/memory_options.h"
#include "experiments/table.h"
#include "mapping/mapping_worlds.h"
#include "picture/kept_map_picture.h"
#include "routes/explore_trial.h"
#include "trials/lab_program.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

using experiments::fixed;

struct Sums {
  int runs = 0, done = 0, home = 0, seen_enough = 0, quick = 0;
  double seen = 0.0, ratio = 0.0;
  double to_frontiers = 0.0, in_vain = 0.0;  ///< [m]
  std::size_t false_ties = 0, wrong = 0, answers = 0;
};

void add(const routes::ExploreResult& found, Sums& sums) {
  const double ratio = found.way / std::max(found.tour, 1.0);
  ++sums.runs;
  sums.done += found.is_done ? 1 : 0;
  sums.home += found.is_home ? 1 : 0;
  sums.seen_enough += found.seen >= 0.95 ? 1 : 0;
  sums.quick += ratio <= 1.6 ? 1 : 0;
  sums.seen += found.seen;
  sums.ratio += ratio;
  sums.to_frontiers += found.account.fruitful + found.account.fruitless;
  sums.in_vain += found.account.fruitless;
  sums.false_ties += found.map.false_ties;
  sums.wrong += found.map.wrong;
  sums.answers += found.map.answers;
}

void write(const Sums& sums) {
  const double runs = std::max(sums.runs, 1);
  std::cout << "\nOf " << sums.runs << ": " << sums.done << " say that they are done, " << sums.home
            << " come home, " << sums.seen_enough << " see 95 % or more, " << sums.quick
            << " drive 1.6 tours or less. On an average " << fixed(100.0 * sums.seen / runs, 1)
            << " % are seen and " << fixed(sums.ratio / runs, 2) << " tours driven. Of "
            << fixed(sums.to_frontiers, 0) << " m to frontiers " << fixed(sums.in_vain, 0)
            << " in vain; " << sums.false_ties << " false ties, " << sums.wrong << " of "
            << sums.answers << " answers wrong.\n";
}

std::vector<std::string> row(const std::string& name, const routes::ExploreResult& found) {
  return {name,
          fixed(found.way, 0),
          fixed(found.tour, 0),
          fixed(found.way / std::max(found.tour, 1.0), 2),
          fixed(100.0 * found.seen, 1),
          std::to_string(found.viewpoints),
          fixed(found.account.enough, 0),
          fixed(found.account.fruitful, 0),
          fixed(found.account.fruitless, 0),
          fixed(found.account.loops, 0),
          fixed(found.account.home, 0),
          std::to_string(found.account.in_vain) + " of " + std::to_string(found.account.tasks),
          found.ended,
          found.is_home ? "yes" : "no",
          fixed(found.time / 60.0, 0),
          std::to_string(found.blocked),
          std::to_string(found.loops),
          std::to_string(found.left.size()),
          std::to_string(found.map.places),
          std::to_string(found.map.doubled),
          std::to_string(found.map.false_ties),
          std::to_string(found.map.wrong) + " of " + std::to_string(found.map.answers),
          fixed(found.map.final_scale_free, 2),
          fixed(found.decision, 1),
          fixed(found.longest_decision, 1)};
}

void draw(const routes::ExploreResult& found, const std::string& path) {
  const config::Parameters parameters = config::loadParameters({});
  picture::DrawnMap map = picture::drawnMap(
      found.kept, {config::fusedMapOptions(parameters), parameters.grid, parameters.sonar},
      [](core::PlaceId id) { return std::to_string(id); });
  picture::writeMapPicture(map, path);
}

int run(const po::variables_map& given) {
  routes::ExploreRecipe recipe;
  recipe.compass = given.count("no-compass") == 0;
  recipe.drive.people = given["people"].as<int>();
  recipe.radius = given["radius"].as<double>();
  recipe.clearance = given["clearance"].as<double>();
  recipe.explorer.space.radius = given["room"].as<double>();
  recipe.explorer.frontiers.least_width = given["width"].as<double>();
  recipe.explorer.frontiers.least_opens = given["opens"].as<double>();
  recipe.explorer.looked_around = given["looked"].as<double>();
  recipe.explorer.gain = given["gain"].as<double>();
  recipe.explorer.constancy = given["constancy"].as<double>();
  recipe.explorer.doubt = given["doubt"].as<double>();
  recipe.explorer.sight.reach = given["sight"].as<double>();
  recipe.explorer.sight.beyond = given["beyond"].as<double>();
  recipe.explorer.frontiers.looks_out = given["looks-out"].as<double>();
  recipe.explorer.barrier = given["barrier"].as<double>();
  recipe.explorer.squeeze = given["squeeze"].as<double>();
  recipe.explorer.patience.least = given["patience"].as<double>();
  recipe.explorer.patience.share = given["patience-share"].as<double>();
  recipe.explorer.worth_a_try = given["worth"].as<double>();
  if (!recipe.compass) recipe.drive.compass_sigma = -1.0;
  experiments::Table table(
      {"building",    "way",          "tour",       "ratio",    "seen %",       "viewpoints",
       "way to 95 %", "to new floor", "in vain",    "to loops", "home",         "frontiers in vain",
       "ended",       "home",         "min",        "blocked",  "loops sought", "left",
       "places",      "doubled",      "false ties", "wrong",    "rms",          "ms to decide",
       "longest"});
  Sums sums;
  const int seeds = given["seeds"].as<int>();
  for (const std::string& name : given["world"].as<std::vector<std::string>>()) {
    for (int i = 0; i < seeds; ++i) {
      const std::uint64_t seed =
          given["first-seed"].as<std::uint64_t>() + static_cast<std::uint64_t>(i);
      const sim::World world = mapping::mappingWorld(name, seed, given["worlds"].as<std::string>());
      routes::ExploreRecipe of_seed = recipe;
      of_seed.drive.start = seed % world.places.size();
      const routes::ExploreResult found = routes::explore(world, of_seed, seed);
      const std::string label = name + " " + std::to_string(seed);
      table.add(row(label, found));
      if (given.count("pictures")) {
        draw(found,
             given["pictures"].as<std::string>() + name + "_" + std::to_string(seed) + ".png");
      }
      if (given.count("verbose")) {
        for (const std::string& cell : row(label, found)) std::cerr << cell << " | ";
        std::cerr << '\n';
        for (const auto& left : found.left) {
          std::cerr << "  left " << left.spot.x << ' ' << left.spot.y << ": " << left.why << '\n';
        }
      }
      add(found, sums);
    }
  }
  table.writeMarkdown(std::cout);
  write(sums);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  po::options_description options("usage: place_memory_explore [options]");
  options.add_options()("help", "show this")(
      "world",
      po::value<std::vector<std::string>>()->multitoken()->default_value(
          {"office", "corridor", "open_plan", "laboratory", "home"},
          "office corridor open_plan laboratory home"),
      "those to explore: corridor, open_plan, laboratory, home, or a world file's name")(
      "worlds", po::value<std::string>()->default_value("config/worlds"), "folder of world files")(
      "first-seed", po::value<std::uint64_t>()->default_value(2000), "of buildings and robots")(
      "seeds", po::value<int>()->default_value(4), "robots in each world")(
      "people", po::value<int>()->default_value(0), "who walk about")(
      "radius", po::value<double>()->default_value(routes::ExploreRecipe{}.radius),
      "that the leg driver keeps free [m]")(
      "clearance", po::value<double>()->default_value(routes::ExploreRecipe{}.clearance),
      "likewise, ahead [m]")("room",
                             po::value<double>()->default_value(core::FreeSpaceOptions{}.radius),
                             "that ways leave to each side on the map [m]")(
      "width", po::value<double>()->default_value(core::FrontierOptions{}.least_width),
      "of a frontier, at least [m]")(
      "opens", po::value<double>()->default_value(core::FrontierOptions{}.least_opens),
      "that is unknown beyond it, at least [m^2]")(
      "looked", po::value<double>()->default_value(core::ExplorerOptions{}.looked_around),
      "where the robot was, nothing so near is a frontier [m]")(
      "gain", po::value<double>()->default_value(core::ExplorerOptions{}.gain),
      "way that a square metre that opens is worth [m]")(
      "constancy", po::value<double>()->default_value(core::ExplorerOptions{}.constancy),
      "by so much another frontier must be nearer [m]")(
      "doubt", po::value<double>()->default_value(core::ExplorerOptions{}.doubt),
      "from so much uncertainty on loops are sought [m]")(
      "sight", po::value<double>()->default_value(core::SightOptions{}.reach),
      "of the sonars, in which they miss nothing [m]")(
      "beyond", po::value<double>()->default_value(core::SightOptions{}.beyond),
      "what is known the robot has looked so far [m]")(
      "looks-out", po::value<double>()->default_value(core::FrontierOptions{}.looks_out),
      "around a frontier it is counted what is unknown [m]")(
      "barrier", po::value<double>()->default_value(core::ExplorerOptions{}.barrier),
      "radius of what bars the way [m]")(
      "squeeze", po::value<double>()->default_value(core::ExplorerOptions{}.squeeze),
      "share of the room that ways leave, where nothing else is left")(
      "patience", po::value<double>()->default_value(core::PatienceOptions{}.least),
      "it drives so far without coming to new ground before it gives up, at the least [m]")(
      "patience-share", po::value<double>()->default_value(core::PatienceOptions{}.share),
      "and as this share of the way before")(
      "worth", po::value<double>()->default_value(core::ExplorerOptions{}.worth_a_try),
      "what bars the way to less is not tried again [m^2]")("no-compass", "robots have none")(
      "pictures", po::value<std::string>(), "prefix of a picture of each map")(
      "verbose", "each row as it comes, and what was left");
  return trials::runProgram("place_memory_explore", argc, argv, options, run);
}
