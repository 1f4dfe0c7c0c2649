#ifndef PLACE_MEMORY_EXPERIMENTS_BATCH_H
#define PLACE_MEMORY_EXPERIMENTS_BATCH_H

#include <cstdint>
#include <vector>

#include "experiments/method.h"
#include "sim/world/world.h"
#include "trials/simulated_trials.h"

namespace place_memory::experiments {

/// One memory, the scans of its places, and scans of another building.
struct Batch {
  trials::TrialSet known;
  std::vector<trials::RecognitionTrial> strangers;
  /// So many of the known scans, evenly spread, are put once more to the memory without the places
  /// that are near: scans of this building where the robot never learned.
  std::size_t unlearned = 0;
};

/// Places that are nearer than this to a scan are what it could rightly be recognized as [m].
constexpr double kNear = 2.5;

/// Seeds of generated buildings in reports. Fitting uses buildings below this one.
constexpr std::uint64_t kFirstReportedBuilding = 1000000;
/// Least seed of a report on the shipped worlds.
constexpr std::uint64_t kFirstReportedSeed = 1000;

/// A building in which the paper's robot can drive, for reports: its kind changes from seed to
/// seed.
sim::World reportedBuilding(std::uint64_t seed);

/// Trials of `world` by the recipe; at most `strangers` scans, by the same robot and recipe, of
/// another building, which differs from seed to seed; and as many of this one that are put to the
/// memory as if never learned.
Batch simulateBatch(const sim::World& world, const sim::SimulatedRobot& robot,
                    trials::Recipe recipe, Sensor sensor, std::uint64_t seed,
                    std::size_t strangers);

/// At most `count` of the items, evenly spread over their order.
template <typename T>
void thinOut(std::vector<T>& items, std::size_t count) {
  if (items.size() <= count) return;
  std::vector<T> kept;
  for (std::size_t i = 0; i < count; ++i) {
    kept.push_back(std::move(items[i * items.size() / count]));
  }
  items = std::move(kept);
}

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_BATCH_H
