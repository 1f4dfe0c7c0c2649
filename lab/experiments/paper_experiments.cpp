#include "experiments/experiment.h"
#include "experiments/recipes.h"
#include "sim/scene/world_loader.h"

namespace place_memory::experiments {
namespace {

constexpr std::size_t kStrangers = 12;

Experiment inWorld(const std::string& group, const std::string& name, const sim::World& world,
                   const trials::Recipe& recipe) {
  Experiment experiment;
  experiment.group = group;
  experiment.name = name;
  experiment.make = [&world, recipe](std::uint64_t seed, Sensor sensor) {
    return simulateBatch(world, sim::SimulatedRobot{}, recipe, sensor, seed, kStrangers);
  };
  return experiment;
}

std::string chairs(int count) {
  return std::to_string(count) + (count == 1 ? " chair" : " chairs");
}

}  // namespace

ShippedWorlds loadShippedWorlds(const std::string& folder) {
  return {sim::loadWorld(folder + "/rooms.yaml"), sim::loadWorld(folder + "/office.yaml"),
          sim::loadWorld(folder + "/hallway.yaml")};
}

std::vector<Experiment> paperExperiments(const ShippedWorlds& worlds) {
  constexpr double kNearest[] = {0.8, 0.6, 0.2, 0.2};  // paper, figure 3
  constexpr double kClimbing[] = {1.0, 0.8, 0.8, 0.8};
  std::vector<Experiment> all;
  for (int i = 0; i <= 3; ++i) {
    all.push_back(inWorld("1", chairs(i), worlds.rooms, roomsRecipe(i, 0.0)));
    if (i > 0) all.back().paper = {{"nearest_neighbour", 1.0}, {"hill_climbing", 1.0}};
  }
  for (int i = 0; i <= 3; ++i) {
    all.push_back(inWorld("2", "2 ft away, " + chairs(i), worlds.rooms, roomsRecipe(i, kTwoFeet)));
    all.back().paper = {{"nearest_neighbour", kNearest[i]}, {"hill_climbing", kClimbing[i]}};
  }
  all.push_back(inWorld("3", "office", worlds.office, officeRecipe(0.0)));
  // Nine tenths of the places always, the others three times out of four (paper 7).
  all.back().paper = {{"hill_climbing", 0.9 * 1.0 + 0.1 * 0.75}};
  all.push_back(inWorld("4", "hallway", worlds.hallway, hallwayRecipe(0.0)));
  all.back().paper = {{"nearest_neighbour", 18.0 / 21.0}, {"hill_climbing", 1.0}};
  all.push_back(inWorld("5", "hallway, 2 ft along it", worlds.hallway, hallwayRecipe(kTwoFeet)));
  all.back().paper = {{"nearest_neighbour", 10.0 / 21.0}, {"hill_climbing", 15.0 / 21.0}};
  return all;
}

std::vector<Experiment> putBackExperiments(const ShippedWorlds& worlds) {
  return {inWorld("put_back", "rooms, 3 chairs", worlds.rooms, roomsRecipe(3, kThreeInches)),
          inWorld("put_back", "office", worlds.office, officeRecipe(kThreeInches)),
          inWorld("put_back", "hallway", worlds.hallway, hallwayRecipe(kThreeInches))};
}

}  // namespace place_memory::experiments
