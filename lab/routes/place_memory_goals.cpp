// Drives a simulated robot to places of a building whose ways close while it is on its way, and
// says what came of its goals.

#include <boost/program_options.hpp>
#include <cstdlib>
#include <iostream>
#include <string>

#include "routes/office_goals.h"
#include "sim/scene/world_loader.h"
#include "trials/lab_program.h"

namespace place_memory::routes {
namespace {

namespace po = boost::program_options;

int run(const po::variables_map& given) {
  const sim::World world = sim::loadWorld(given["world"].as<std::string>());
  const int goals = given["goals"].as<int>();
  std::cout << "| seed | goals | reached | no route | stuck | other ends | closed on the way | "
               "blocked links | false: reached, no route, blocked | longest plan [ms] | driven [m] "
               "|\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  std::string messages;
  for (int seed = 1; seed <= given["seeds"].as<int>(); ++seed) {
    const GoalCounts counts =
        driveGoals(world, goals, static_cast<std::uint64_t>(seed), given["astray"].as<double>());
    std::cout << "| " << seed << " | " << goals << " | " << counts.reached << " | "
              << counts.no_route << " | " << counts.stuck << " | " << counts.others << " | "
              << counts.closed_ahead << " | " << counts.blocked << " | " << counts.false_reached
              << ", " << counts.false_no_route << ", " << counts.false_blocked << " | "
              << 1000.0 * counts.longest_plan << " | " << counts.way << " |" << std::endl;
    messages += counts.messages;
  }
  std::cerr << messages;
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace place_memory::routes

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  po::options_description options("usage: place_memory_goals");
  options.add_options()("help", "show this")(
      "world", po::value<std::string>()->default_value("config/worlds/office.yaml"),
      "file of the building")("goals", po::value<int>()->default_value(200), "a seed")(
      "seeds", po::value<int>()->default_value(5), "runs")(
      "astray", po::value<double>()->default_value(0.0),
      "the robot takes itself to be up to so far from where it is [m]");
  return place_memory::trials::runProgram("place_memory_goals", argc, argv, options,
                                          place_memory::routes::run);
}
