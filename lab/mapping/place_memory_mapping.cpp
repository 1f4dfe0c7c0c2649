// Drives simulated robots about simulated buildings while they map, and prints tables of what came
// of it.
#include <boost/program_options.hpp>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "mapping/suites.h"
#include "trials/lab_program.h"

namespace po = boost::program_options;
using namespace place_memory;

namespace place_memory::mapping {

const std::map<std::string, std::function<experiments::Table(const SuiteOptions&)>>& suites() {
  static const std::map<std::string, std::function<experiments::Table(const SuiteOptions&)>> kAll{
      {"drives", driveSuite},   {"sonars", sonarSuite}, {"out_and_back", outAndBackSuite},
      {"kidnaps", kidnapSuite}, {"starts", startSuite}, {"sessions", sessionSuite},
      {"links", linkSuite},     {"soak", soakSuite},    {"recorded", recordedSuite},
      {"halves", halvesSuite},  {"fit_lost", lostFit}};
  return kAll;
}

}  // namespace place_memory::mapping

namespace {

int run(const po::variables_map& given, mapping::SuiteOptions options) {
  const std::string name = given["suite"].as<std::string>();
  const auto suite = mapping::suites().find(name);
  if (suite == mapping::suites().end()) {
    std::string names;
    for (const auto& [known, run] : mapping::suites()) names += " " + known;
    throw std::runtime_error("there is no suite " + name + "; there are:" + names);
  }
  options.compass = given.count("no-compass") == 0;
  options.sums = given.count("sums") > 0;
  if (given.count("world")) options.names = given["world"].as<std::vector<std::string>>();
  const experiments::Table table = suite->second(options);
  if (given.count("csv")) {
    table.writeCsv(std::cout);
  } else {
    table.writeMarkdown(std::cout);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  mapping::SuiteOptions suite;
  po::options_description options("usage: place_memory_mapping SUITE [options]");
  options.add_options()("help", "show this")(
      "suite", po::value<std::string>()->required(),
      "drives, sonars, out_and_back, kidnaps, starts, sessions, links, soak, recorded, halves or "
      "fit_lost")(
      "world", po::value<std::vector<std::string>>()->multitoken(),
      "those to drive about in: corridor, open_plan, laboratory, home, cells, half_turn, or a "
      "world file's name")("worlds", po::value(&suite.worlds)->default_value("config/worlds"),
                           "folder of world files")(
      "drive", po::value(&suite.drives)->multitoken(),
      "recorded ones, for recorded and halves: files with the truth")(
      "first-seed", po::value(&suite.first_seed)->default_value(suite.first_seed),
      "of buildings and drives")("seeds", po::value(&suite.seeds)->default_value(suite.seeds),
                                 "drives in each world")(
      "way", po::value(&suite.way)->default_value(suite.way), "of a drive [m]")(
      "scale-sigma", po::value(&suite.noise.scale_sigma)->default_value(suite.noise.scale_sigma),
      "of odometry's distances")(
      "yaw-noise", po::value(&suite.noise.yaw_noise)->default_value(suite.noise.yaw_noise),
      "of odometry [rad by the root of the way in m]")("no-compass", "robots have none")(
      "sums", "of drives: a row for all seeds together")("csv", "print comma separated values");
  po::positional_options_description places;
  places.add("suite", 1);
  return place_memory::trials::runProgram(
      "place_memory_mapping", argc, argv, options,
      [&](const po::variables_map& given) { return run(given, suite); }, places);
}
