// Simulates a drive through a world or a generated building and writes it as a drive file.

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "mapping/mapping_worlds.h"
#include "trials/lab_program.h"
#include "trials/simulated_drive.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace {

int run(const po::variables_map& given) {
  const auto seed = given["seed"].as<std::uint64_t>();
  const sim::World world = mapping::mappingWorld(given["world"].as<std::string>(), seed,
                                                 given["worlds"].as<std::string>());
  trials::DriveRecipe recipe;
  recipe.way = given["way"].as<double>();
  recipe.speed = given["speed"].as<double>();
  recipe.people = given["people"].as<int>();
  recipe.changes = given.count("unchanged") == 0;
  recipe.scale_sigma = given["scale-sigma"].as<double>();
  recipe.yaw_noise = given["yaw-noise"].as<double>();
  if (given.count("carried")) recipe.carried = given["carried"].as<std::vector<double>>();
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
  po::options_description options("usage: place_memory_simulate_drive --out F.jsonl.gz");
  options.add_options()("help", "show this")("out", po::value<std::string>()->required(),
                                             "file to write")(
      "world", po::value<std::string>()->default_value("office"),
      "to drive about in: corridor, open_plan, laboratory, home, cells, half_turn, or a world "
      "file's name")("worlds", po::value<std::string>()->default_value("config/worlds"),
                     "folder of world files")("seed", po::value<std::uint64_t>()->default_value(1),
                                              "of all that is random")(
      "way", po::value<double>()->default_value(200.0), "[m]")(
      "speed", po::value<double>()->default_value(0.35), "[m/s]")(
      "people", po::value<int>()->default_value(2), "who walk about")(
      "start", po::value<std::size_t>()->default_value(0), "number of the place to start at")(
      "sonars", po::value<int>()->default_value(16), "of the ring of 16: 16, 8, 4")(
      "scale-sigma", po::value<double>()->default_value(0.02), "of odometry's distances")(
      "yaw-noise", po::value<double>()->default_value(0.0262),
      "of odometry [rad by the root of the way in m]")(
      "carried", po::value<std::vector<double>>()->multitoken(),
      "ways at which it is carried elsewhere, rising [m]")(
      "ahead", "the forward nine of them alone")("unchanged", "nothing changes half way");
  return place_memory::trials::runProgram("place_memory_simulate_drive", argc, argv, options, run);
}
