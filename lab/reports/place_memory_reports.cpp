// Measures the reports of twins and of changes in simulated worlds.

#include <boost/program_options.hpp>
#include <iostream>
#include <string>

#include "config/load_parameters.h"
#include "core/sensing/scan_changes.h"
#include "mapping/mapping_worlds.h"
#include "reports/change_trial.h"
#include "reports/twin_trial.h"
#include "sim/building/building_generator.h"
#include "sim/scene/world_loader.h"
#include "trials/lab_program.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

std::string share(std::size_t part, std::size_t whole) {
  const double number = whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
  return std::to_string(part) + " of " + std::to_string(whole) + " (" + std::to_string(number) +
         ")";
}

/// A building between two visits of one robot.
trials::Recipe recipe() {
  trials::Recipe recipe;
  recipe.compass_error = core::kPi / 18.0;
  recipe.doors_flipped = 0.3;
  recipe.chairs_moved = 0.3;
  recipe.people = 1;
  recipe.shift = 0.3048;
  return recipe;
}

void measureTwins(const po::variables_map& given, const config::Parameters& parameters) {
  core::TwinOptions options;
  options.most = given["most"].as<std::size_t>();
  options.least_likeness = given["likeness"].as<double>();
  reports::TwinVisits coming_back{recipe(), given["rounds"].as<int>()};
  coming_back.recipe.any_heading = given.count("any-heading") > 0;
  if (coming_back.recipe.any_heading) options.heading_window = core::kPi;
  sim::SimulatedRobot robot;
  robot.ring.count = given["sonars"].as<int>();
  robot.ring.spacing = 2.0 * core::kPi / robot.ring.count;
  reports::TwinScore score;
  const auto first = given["first"].as<std::uint64_t>();
  const auto seeds = given["seeds"].as<std::uint64_t>();
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
    std::vector<sim::World> worlds;
    if (given.count("world") > 0)
      worlds.push_back(mapping::mappingWorld(given["world"].as<std::string>(), seed, ""));
    for (std::uint64_t i = 0;
         given.count("world") == 0 && i < given["buildings"].as<std::uint64_t>(); ++i) {
      worlds.push_back(sim::generateBuilding(sim::BuildingKind::kCorridor, 100 * seed + i));
    }
    score.add(reports::tryTwins(worlds, robot, coming_back, seed, parameters, options));
  }
  std::cout << "twins: " << score.pairs << " pairs of " << score.places
            << " places; confused then: " << share(score.pairs_confused, score.pairs)
            << "; confusions: " << share(score.confusions, score.visits)
            << "; named before: " << share(score.named, score.confusions)
            << "; of the last visits': " << score.last
            << "; that earlier visits knew: " << share(score.last_known, score.last) << '\n';
}

void measureChanges(const po::variables_map& given, const config::Parameters& parameters) {
  core::GridChangeOptions options;
  options.sure = given["sure"].as<int>();
  options.least_cells = given["cells"].as<std::size_t>();
  reports::ChangeScore score;
  const sim::World world = sim::loadWorld(given["world"].as<std::string>());
  const auto first = given["first"].as<std::uint64_t>();
  const auto seeds = given["seeds"].as<std::uint64_t>();
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
    score.add(reports::tryChanges(world, seed, parameters, options));
  }
  std::cout << score.places
            << " places; door states right: " << share(score.doors_right, score.doors)
            << "; of the flipped: " << share(score.doors_flipped_right, score.doors_flipped)
            << "; moved things seen: " << share(score.moved_seen, score.moved)
            << "; false changes a place: " << share(score.false_changes, score.places) << '\n';
}

int run(const po::variables_map& given) {
  const config::Parameters parameters =
      config::loadParameters(given["params"].as<std::vector<std::string>>());
  const auto what = given["what"].as<std::string>();
  if (what == "twins") {
    measureTwins(given, parameters);
  } else if (what == "changes") {
    measureChanges(given, parameters);
  } else {
    throw std::runtime_error("twins or changes, not '" + what + "'");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const core::TwinOptions twins;
  const core::GridChangeOptions& changes = core::kScanChangeOptions;
  po::options_description options("usage: place_memory_reports twins|changes [--world F.yaml]");
  auto add = options.add_options();
  add("help", "show this");
  add("what", po::value<std::string>()->required(), "twins or changes");
  add("world", po::value<std::string>(),
      "world file, or for twins a building's name as of place_memory_mapping; twins without it: "
      "generated buildings");
  add("params", po::value<std::vector<std::string>>()->default_value({}, "")->composing(),
      "parameters");
  add("first", po::value<std::uint64_t>()->default_value(9100), "seed");
  add("seeds", po::value<std::uint64_t>()->default_value(20), "how many");
  add("sonars", po::value<int>()->default_value(16), "of the robot");
  add("buildings", po::value<std::uint64_t>()->default_value(10), "that are one map of twins");
  add("rounds", po::value<int>()->default_value(1), "how often a robot comes back, of twins");
  add("any-heading", "without a compass, of twins");
  add("most", po::value<std::size_t>()->default_value(twins.most), "twins of one place");
  add("likeness", po::value<double>()->default_value(twins.least_likeness), "of twins, least");
  add("sure", po::value<int>()->default_value(changes.sure), "evidence of a change");
  add("cells", po::value<std::size_t>()->default_value(changes.least_cells), "of a change");
  po::positional_options_description positions;
  positions.add("what", 1);
  return place_memory::trials::runProgram("place_memory_reports", argc, argv, options, run,
                                          positions);
}
