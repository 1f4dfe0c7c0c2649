#include "training/training_worlds.h"

#include "sim/building/building_generator.h"
#include "sim/robot/random_robot.h"
#include "sim/world/random.h"
#include "trials/simulated_trials.h"

namespace place_memory::training {
namespace {

constexpr double kDegree = core::kPi / 180.0;

trials::Recipe randomRecipe(bool arena, sim::Rng& rng) {
  using sim::chance;
  using sim::uniform;
  trials::Recipe recipe;
  recipe.doors_flipped = uniform(rng, 0.0, 0.5);
  recipe.chairs_moved = uniform(rng);
  recipe.bicycles_added = chance(rng, 0.3) ? sim::uniformInt(rng, 1, 2) : 0;
  recipe.people = sim::uniformInt(rng, 0, 2);
  recipe.chairs_about_place = !arena && chance(rng, 0.4) ? sim::uniformInt(rng, 1, 3) : 0;
  recipe.shift = chance(rng, 0.3) ? 0.0 : uniform(rng, 0.0, arena ? 0.12 : 0.8);
  recipe.shift_along_links = chance(rng, 0.4);
  recipe.compass_error = uniform(rng, 0.0, 30.0 * kDegree);
  recipe.drift = chance(rng, 0.3) ? uniform(rng, 0.0, 30.0 * kDegree) : 0.0;
  recipe.readings_lost = chance(rng, 0.3) ? uniform(rng, 0.0, 0.3) : 0.0;
  recipe.any_heading = chance(rng, arena ? 0.8 : 0.25);
  recipe.turn_error = arena ? 0.05 : 0.0;
  return recipe;
}

/// A grid about as wide as the sensor's reach, as a user would set it up.
double cellSizeFor(double max_range, bool arena) {
  if (arena) return 0.06;
  return max_range < 3.0 ? 0.1 : core::kDefaultCellSize;
}

}  // namespace

trials::TrialSet trainingSet(std::uint64_t seed) {
  std::seed_seq sequence{seed, seed >> 32U, std::uint64_t{0x7261}};
  sim::Rng rng(sequence);
  const auto kind =
      static_cast<sim::BuildingKind>(sim::uniformInt(rng, 0, sim::kBuildingKinds - 1));
  const bool arena = kind == sim::BuildingKind::kArena;
  const sim::World world = sim::generateBuilding(kind, seed);
  const sim::SimulatedRobot robot = arena ? sim::randomSpinningRobot(seed) : sim::randomRobot(seed);
  trials::Recipe recipe = randomRecipe(arena, rng);
  if (arena && sim::chance(rng, 0.7)) recipe.other_robot = sim::randomSpinningRobot(~seed);
  trials::TrialSet set = trials::simulateTrials(world, robot, recipe, seed);
  set.cell_size = cellSizeFor(robot.ring.spec.max_range, arena);
  return set;
}

}  // namespace place_memory::training
