// Simulates a drive through a world or a generated building and writes it as a drive file.

#include <boost/program_options.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "sim/building/building_generator.h"
#include "sim/scene/world_loader.h"
#include "trials/simulated_drive.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

int run(const po::variables_map& given) {
  const auto seed = given["seed"].as<std::uint64_t>();
  const sim::World world =
      given.count("world")
          ? sim::loadWorld(given["world"].as<std::string>())
          : sim::generateBuilding(static_cast<sim::BuildingKind>(given["kind"].as<int>()), seed);
  trials::DriveRecipe recipe;
  recipe.way = given["way"].as<double>();
  recipe.speed = given["speed"].as<double>();
  recipe.people = given["people"].as<int>();
  recipe.changes = given.count("unchanged") == 0;
  recipe.start = given["start"].as<std::size_t>() % world.places.size();
  sim::SimulatedRobot robot;
  const int ring = robot.ring.count;
  for (int i = 0; i < ring; ++i) {
    const double bearing = std::abs(core::wrapAngle(sim::sensorPose(robot.ring, i).yaw));
    if (given.count("ahead") ? bearing < 0.5 * core::kPi + 0.01
                             : i % (ring / given["sonars"].as<int>()) == 0) {
      recipe.sonars.push_back(i);
    }
  }
  trials::writeDriveFile(trials::simulateDrive(world, robot, recipe, seed),
                         given["out"].as<std::string>());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    po::options_description options("usage: place_memory_simulate_drive --out F.jsonl.gz");
    options.add_options()("help", "show this")("out", po::value<std::string>()->required(),
                                               "file to write")(
        "world", po::value<std::string>(), "world file; without it, a generated building")(
        "kind", po::value<int>()->default_value(0), "of that building, by its number")(
        "seed", po::value<std::uint64_t>()->default_value(1), "of all that is random")(
        "way", po::value<double>()->default_value(200.0), "[m]")(
        "speed", po::value<double>()->default_value(0.35), "[m/s]")(
        "people", po::value<int>()->default_value(2), "who walk about")(
        "start", po::value<std::size_t>()->default_value(0), "number of the place to start at")(
        "sonars", po::value<int>()->default_value(16), "of the ring of 16: 16, 8, 4")(
        "ahead", "the forward nine of them alone")("unchanged", "nothing changes half way");
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, options), given);
    if (given.count("help")) {
      std::cout << options;
      return 0;
    }
    po::notify(given);
    return run(given);
  } catch (const std::exception& error) {
    std::cerr << "place_memory_simulate_drive: " << error.what() << '\n';
    return 1;
  }
}
