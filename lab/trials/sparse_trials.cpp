#include "trials/sparse_trials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim/building/building_generator.h"
#include "sim/robot/random_robot.h"
#include "sim/world/random.h"
#include "trials/simulated_trials.h"
#include "trials/sparse_worlds.h"

namespace place_memory::trials {
namespace {

using sim::chance;
using sim::Rng;
using sim::uniform;

constexpr double kDegree = core::kPi / 180.0;
constexpr std::size_t kPlaces = 10;
constexpr double kFarAway = 200.0;  // from one world of a memory to the other [m]

sim::World buildingOf(Rng& rng) {
  const auto kind = static_cast<sim::BuildingKind>(
      sim::uniformInt(rng, 0, static_cast<int>(sim::BuildingKind::kArena) - 1));
  sim::World world = sim::generateBuilding(kind, rng());
  sim::shuffle(world.places, rng);
  world.places.resize(std::min(world.places.size(), kPlaces));
  for (sim::Place& place : world.places) place.links.clear();
  return world;
}

sim::SimulatedRobot fewSensors(Rng& rng) {
  const int counts[] = {1, 3, 4, 4};
  sim::SimulatedRobot robot;
  robot.ring.count = counts[sim::uniformIndex(rng, 4)];
  const bool all_round = robot.ring.count == 4 || chance(rng, 0.3);
  robot.ring.spacing =
      all_round ? 2.0 * core::kPi / robot.ring.count : uniform(rng, 20.0, 60.0) * kDegree;
  robot.ring.first_bearing = all_round ? 0.0 : -0.5 * (robot.ring.count - 1) * robot.ring.spacing;
  robot.ring.radius = uniform(rng, 0.0, 0.2);
  robot.ring.spec = {uniform(rng, 5.0, 35.0) * kDegree, 0.02, uniform(rng, 1.0, 4.5)};
  const bool turns_fully = chance(rng, 0.6);
  robot.sweep.headings = turns_fully ? sim::uniformInt(rng, 24, 72) : sim::uniformInt(rng, 1, 11);
  robot.sweep.step = turns_fully ? 2.0 * core::kPi / robot.sweep.headings : 2.0 * kDegree;
  robot.sweep.set_period = 0.2;
  return robot;
}

sim::SimulatedRobot robotFor(SparseKind kind, Rng& rng) {
  if (kind == SparseKind::kFewSensors) return fewSensors(rng);
  sim::SimulatedRobot robot = sim::randomRobot(rng());
  if (chance(rng, 0.4)) robot = {};  // the paper's
  if (kind == SparseKind::kHall) robot.ring.spec.max_range = uniform(rng, 2.0, 4.572);
  return robot;
}

Recipe recipeFor(Rng& rng) {
  Recipe recipe;
  recipe.chairs_moved = uniform(rng, 0.0, 0.5);
  recipe.doors_flipped = uniform(rng, 0.0, 0.3);
  recipe.shift = chance(rng, 0.3) ? 0.0 : uniform(rng, 0.0, 0.6);
  recipe.compass_error = uniform(rng, 0.0, 20.0 * kDegree);
  recipe.any_heading = chance(rng, 0.25);
  return recipe;
}

/// Puts the places of another world, far away, into the memory as well.
void addMemory(TrialSet more, TrialSet& memory) {
  for (LearnedScan& scan : more.learned) {
    scan.odom_from_scan.x += kFarAway;
    memory.learned.push_back(std::move(scan));
  }
  for (RecognitionTrial& trial : more.trials) {
    trial.odom_from_scan.x += kFarAway;
    memory.trials.push_back(std::move(trial));
  }
}

/// Only a share of the echoes is heard.
void deaden(double share, Rng& rng, std::vector<RecognitionTrial>& trials) {
  for (RecognitionTrial& trial : trials) {
    for (core::SonarReading& reading : trial.readings) {
      if (!chance(rng, share)) reading.range = std::numeric_limits<double>::infinity();
    }
  }
}

/// What comes of ranges that are in another unit, limits included.
void rescale(double factor, std::vector<core::SonarReading>& readings) {
  for (core::SonarReading& reading : readings) {
    reading.range *= factor;
    reading.spec.min_range *= factor;
    reading.spec.max_range *= factor;
  }
}

void rescale(double factor, std::vector<RecognitionTrial>& trials) {
  for (RecognitionTrial& trial : trials) rescale(factor, trial.readings);
}

double anyUnit(Rng& rng) {
  constexpr std::array<double, 8> kUnits{0.001, 0.01, 0.0254, 0.1, 0.3048, 3.2808, 10.0, 100.0};
  return kUnits[sim::uniformIndex(rng, kUnits.size())];
}

SparseTrials ofWorlds(const sim::World& learned, const sim::World& elsewhere,
                      const sim::SimulatedRobot& robot, const Recipe& recipe, Rng& rng) {
  SparseTrials made;
  made.known = simulateTrials(learned, robot, recipe, rng());
  made.strangers = simulateStrangers(elsewhere, robot, recipe, rng());
  return made;
}

}  // namespace

const char* nameOf(SparseKind kind) {
  constexpr std::array<const char*, kEverySparseKind.size()> kNames{
      "open space", "hall", "dead ring", "wrong units", "few sensors"};
  return kNames[static_cast<std::size_t>(kind)];
}

SparseTrials simulateSparse(SparseKind kind, std::uint64_t seed) {
  std::seed_seq sequence{seed, seed >> 32U, std::uint64_t{0x737061},
                         static_cast<std::uint64_t>(kind)};
  Rng rng(sequence);
  const sim::SimulatedRobot robot = robotFor(kind, rng);
  const Recipe recipe = recipeFor(rng);
  const auto sparse = [&] {
    return chance(rng, 0.5) ? openSpace(kPlaces, rng) : hall(kPlaces, rng);
  };
  SparseTrials made;
  if (kind == SparseKind::kOpenSpace) {
    made = ofWorlds(openSpace(kPlaces, rng), openSpace(kPlaces, rng), robot, recipe, rng);
  } else if (kind == SparseKind::kHall) {
    made = ofWorlds(hall(kPlaces, rng), hall(kPlaces, rng), robot, recipe, rng);
  } else if (kind == SparseKind::kFewSensors) {
    made = ofWorlds(chance(rng, 0.6) ? buildingOf(rng) : sparse(),
                    chance(rng, 0.6) ? buildingOf(rng) : sparse(), robot, recipe, rng);
  } else {
    made = ofWorlds(buildingOf(rng), buildingOf(rng), robot, recipe, rng);
    addMemory(simulateTrials(sparse(), robot, recipe, rng()), made.known);
  }
  if (kind == SparseKind::kDeadRing) {
    const double heard = chance(rng, 0.2) ? 0.0 : uniform(rng, 0.01, 0.3);
    deaden(heard, rng, made.strangers);
    deaden(heard, rng, made.known.trials);
  }
  if (kind == SparseKind::kWrongUnits) {
    const double factor = anyUnit(rng);
    rescale(factor, made.strangers);
    rescale(factor, made.known.trials);
    for (LearnedScan& scan : made.known.learned) rescale(factor, scan.readings);
  }
  made.known.name = nameOf(kind);
  const double reach = robot.ring.spec.max_range;
  made.known.cell_size = reach < 3.0 ? 0.1 : core::kDefaultCellSize;
  return made;
}

}  // namespace place_memory::trials
