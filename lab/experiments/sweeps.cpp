#include <algorithm>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "experiments/experiment.h"
#include "experiments/recipes.h"

namespace place_memory::experiments {
namespace {

using sim::SimulatedRobot;
using trials::Recipe;

/// A curve: its points, and what each does to recipe, robot and cell size.
struct Curve {
  const char* name;
  std::vector<double> points;
  Experiment (*at)(double x, const ShippedWorlds& worlds);
};

Experiment inWorld(const sim::World& world, const Recipe& recipe, const SimulatedRobot& robot = {},
                   double cell_size = core::kDefaultCellSize) {
  Experiment experiment;
  experiment.make = [&world, recipe, robot, cell_size](std::uint64_t seed, Sensor sensor) {
    Batch batch = simulateBatch(world, robot, recipe, sensor, seed, 0);
    batch.known.cell_size = cell_size;
    return batch;
  };
  return experiment;
}

Experiment withChairs(double count, const ShippedWorlds& worlds) {
  return inWorld(worlds.rooms, roomsRecipe(static_cast<int>(count), kTwoFeet));
}

Experiment withShift(double metres, const ShippedWorlds& worlds) {
  return inWorld(worlds.hallway, hallwayRecipe(metres));
}

Experiment withHeadingError(double degrees, const ShippedWorlds& worlds) {
  Recipe recipe = hallwayRecipe(0.0);
  recipe.drift = 0.0;
  recipe.compass_error = degrees * kDegree;
  recipe.heading_window = std::max(recipe.heading_window, recipe.compass_error);
  return inWorld(worlds.hallway, recipe);
}

Experiment withCellSize(double metres, const ShippedWorlds& worlds) {
  return inWorld(worlds.hallway, hallwayRecipe(kTwoFeet), SimulatedRobot{}, metres);
}

Experiment withSonars(double count, const ShippedWorlds& worlds) {
  SimulatedRobot robot;
  robot.ring.count = static_cast<int>(count);
  robot.ring.spacing = 2.0 * core::kPi / count;
  return inWorld(worlds.hallway, hallwayRecipe(kTwoFeet), robot);
}

Experiment withReadingsLost(double share, const ShippedWorlds& worlds) {
  Recipe recipe = hallwayRecipe(kTwoFeet);
  recipe.readings_lost = share;
  return inWorld(worlds.hallway, recipe);
}

/// Puts a building's places beside those of the buildings before it.
void append(trials::TrialSet&& building, std::size_t number, trials::TrialSet& all) {
  constexpr double kApart = 1000.0;  // [m]
  const std::string prefix = std::to_string(number) + "/";
  for (trials::LearnedScan& scan : building.learned) {
    scan.label.insert(0, prefix);
    scan.odom_from_scan.x += kApart * static_cast<double>(number);
    all.learned.push_back(std::move(scan));
  }
  for (trials::RecognitionTrial& trial : building.trials) {
    for (std::string& label : trial.accept) label.insert(0, prefix);
    trial.odom_from_scan.x += kApart * static_cast<double>(number);
    all.trials.push_back(std::move(trial));
  }
}

/// Exactly `count` places of as many buildings as that takes.
trials::TrialSet manyPlaces(std::size_t count, Sensor sensor, std::uint64_t seed) {
  constexpr std::uint64_t kMostBuildings = 1000;
  trials::TrialSet all;
  for (std::size_t i = 0; all.learned.size() < count; ++i) {
    const sim::World building = reportedBuilding(seed * kMostBuildings + i);
    append(simulateBatch(building, SimulatedRobot{}, buildingRecipe(), sensor, seed, 0).known, i,
           all);
  }
  all.learned.resize(count);
  const auto is_gone = [&](const trials::RecognitionTrial& trial) {
    return std::none_of(all.learned.begin(), all.learned.end(), [&](const auto& scan) {
      return std::count(trial.accept.begin(), trial.accept.end(), scan.label) > 0;
    });
  };
  all.trials.erase(std::remove_if(all.trials.begin(), all.trials.end(), is_gone), all.trials.end());
  return all;
}

Experiment withPlaces(double count, const ShippedWorlds& /*worlds*/) {
  constexpr std::size_t kTrials = 20;
  Experiment experiment;
  experiment.make = [count](std::uint64_t seed, Sensor sensor) {
    Batch batch{manyPlaces(static_cast<std::size_t>(count), sensor, seed), {}};
    thinOut(batch.known.trials, kTrials);
    return batch;
  };
  return experiment;
}

const std::vector<Curve>& curves() {
  static const std::vector<Curve> kCurves = {
      {"chairs", {0, 1, 2, 3, 4, 5, 6}, withChairs},
      {"shift", {0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.2}, withShift},
      {"heading_error", {0, 10, 20, 30, 45, 60, 90}, withHeadingError},
      {"cell_size", {0.06, 0.08, 0.1, 0.142875, 0.2, 0.3, 0.45}, withCellSize},
      {"places", {5, 10, 20, 50, 100, 200}, withPlaces},
      {"sonars", {4, 6, 8, 12, 16, 24, 32}, withSonars},
      {"readings_lost", {0.0, 0.1, 0.25, 0.5, 0.75, 0.9}, withReadingsLost},
  };
  return kCurves;
}

}  // namespace

std::vector<std::string> sweepNames() {
  std::vector<std::string> names;
  for (const Curve& curve : curves()) names.emplace_back(curve.name);
  return names;
}

std::vector<Experiment> sweep(const std::string& name, const ShippedWorlds& worlds) {
  for (const Curve& curve : curves()) {
    if (name != curve.name) continue;
    std::vector<Experiment> points;
    for (const double x : curve.points) {
      std::ostringstream text;
      text << x;
      points.push_back(curve.at(x, worlds));
      points.back().group = name;
      points.back().name = text.str();
      points.back().x = x;
    }
    return points;
  }
  throw std::runtime_error("'" + name + "' is not a sweep");
}

}  // namespace place_memory::experiments
