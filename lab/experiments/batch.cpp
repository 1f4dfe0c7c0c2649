#include "experiments/batch.h"

#include "sim/building/building_generator.h"

namespace place_memory::experiments {

sim::World reportedBuilding(std::uint64_t seed) {
  constexpr sim::BuildingKind kKinds[] = {sim::BuildingKind::kCorridor,
                                          sim::BuildingKind::kOpenPlan,
                                          sim::BuildingKind::kLaboratory, sim::BuildingKind::kHome};
  return sim::generateBuilding(kKinds[seed % std::size(kKinds)], kFirstReportedBuilding + seed);
}

Batch simulateBatch(const sim::World& world, const sim::SimulatedRobot& robot,
                    trials::Recipe recipe, Sensor sensor, std::uint64_t seed,
                    std::size_t strangers) {
  if (sensor == Sensor::kLaser) recipe.laser = sim::LaserModel{};
  Batch batch;
  batch.known = trials::simulateTrials(world, robot, recipe, seed);
  if (strangers > 0) {
    const sim::World elsewhere = reportedBuilding(seed);
    batch.strangers = trials::simulateStrangers(elsewhere, robot, recipe, seed);
    thinOut(batch.strangers, strangers);
    batch.unlearned = strangers;
  }
  return batch;
}

}  // namespace place_memory::experiments
